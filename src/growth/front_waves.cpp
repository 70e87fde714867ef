// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/front_waves.hpp"

#include "base/dense_solve.hpp"
#include "base/vec.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spricka::growth {

namespace {

// Of 17 points of an open front, and of 32 of a closed one; of more, where two fronts have become
// one, as many more; of fewer, where one has become two, as many less.
struct FrontFitOrders {
  int round = 0; ///< degree of the polynomial, of a front that turns
  int straight = 0;
  int harmonics = 0;
};
constexpr FrontFitOrders rates{.round = 8, .straight = 4, .harmonics = 12};
constexpr FrontFitOrders turns{.round = 8, .straight = 2, .harmonics = 10};
/// Ends of a front through a plate answer to falling behind more steeply than a wave of an endless
/// front does, by up to so many times: a decay that is taken as too steep only slows the steps'
/// corrections, one that is too flat lets ends swing from step to step.
constexpr double of_ends = 2.5;
/// What rates of before, and the deferred advance, may add to an advance or take away: parts of it.
constexpr double least_part = 0.5;
constexpr double largest_part = 2.0;

base::Vector vector_of(const std::vector<double>& values) {
  return base::Vector(base::Vector::Map(values.data(), static_cast<Eigen::Index>(values.size())));
}

// Waves [column] of unit height at the points of an arc, and how many halves of each it has.
struct Waves {
  base::Matrix shape;
  base::Vector halves;

  Waves(Eigen::Index n, bool closed) : shape(n, n), halves(n) {
    for (Eigen::Index k = 0; k < n; ++k) {
      halves[k] = static_cast<double>(closed ? (k + 1) / 2 * 2 : k);
      for (Eigen::Index i = 0; i < n; ++i) {
        const double turn = std::numbers::pi * halves[k] * static_cast<double>(i) /
                            static_cast<double>(closed ? n : n - 1);
        shape(i, k) = closed && k % 2 == 0 && k > 0 ? std::sin(turn) : std::cos(turn);
      }
    }
  }
  /// What dies of each by an advance of 1, of a front with this stiffness [1/length].
  [[nodiscard]] base::Vector decay(double stiffness) const {
    return 0.5 * stiffness * std::numbers::pi * halves;
  }
  [[nodiscard]] base::Vector heights(const base::Vector& values) const {
    return base::solve_square_system(shape, values);
  }
};

// The polynomial or the harmonics that fit values [point] along an arc best, at its points; the
// values themselves where there are too few.
std::vector<double> fitted(const base::Vector& values, FrontKind kind, const FrontFitOrders& fit) {
  const bool closed = kind == FrontKind::closed;
  const int degree = kind == FrontKind::straight ? fit.straight : fit.round;
  const Eigen::Index n = values.size();
  const Eigen::Index count =
      closed ? 2 * std::max<Eigen::Index>(1, n * fit.harmonics / closed_front_points) + 1
             : (n > closed_front_points || n < open_front_points
                    ? std::max<Eigen::Index>(2, n * degree / open_front_points)
                    : degree) +
                   1;
  if (n <= count) {
    return {values.begin(), values.end()};
  }
  base::Matrix shape(n, count);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(closed ? n : n - 1);
    for (Eigen::Index k = 0; k < count; ++k) {
      const Eigen::Index order = (k + 1) / 2;
      const double turn = 2.0 * std::numbers::pi * static_cast<double>(order) * part;
      shape(i, k) = !closed      ? std::cos(static_cast<double>(k) * std::acos(2.0 * part - 1.0))
                    : k % 2 == 0 ? std::cos(turn)
                                 : std::sin(turn);
    }
  }
  const base::Vector found = shape * base::least_squares(shape, values);
  return {found.begin(), found.end()};
}

// Integrals of exp(-z t) and t exp(-z (1 - t)) over an advance, t from 0 to 1; series where the
// closed forms cancel.
double decayed(double z) {
  return z < 1e-4 ? 1.0 - 0.5 * z : -std::expm1(-z) / z;
}
double decayed_rise(double z) {
  return z < 1e-4 ? 0.5 - z / 6.0 : (std::expm1(-z) + z) / (z * z);
}

} // namespace

std::vector<double> FrontGrowthRates::point_advances(double mean) const {
  const auto n = static_cast<Eigen::Index>(rate.size());
  const Waves waves(n, kind == FrontKind::closed);
  const base::Vector now = vector_of(rate) / vector_of(rate).mean();
  const base::Vector due = vector_of(deferred_advance).array() - vector_of(deferred_advance).mean();
  const base::Vector share = waves.heights(now);
  const base::Vector missed = waves.heights(due);
  const double steep = kind == FrontKind::straight ? of_ends * stiffness : stiffness;
  const base::Vector decay = waves.decay(steep);
  base::Vector first(n);
  base::Vector more(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    first[k] = mean * decayed(decay[k] * mean) * share[k];
    more[k] = std::exp(-decay[k] * mean) * missed[k];
  }
  const double mean_before = last.empty() ? 0.0 : vector_of(last).mean();
  if (!rate_before.empty() && mean_before > 0.0) {
    const base::Vector before = vector_of(rate_before) / vector_of(rate_before).mean();
    // What a wave's rate has changed by beside what its own height took away.
    const base::Vector change =
        waves.heights(now - before) + decay.cwiseProduct(waves.heights(vector_of(last)));
    for (Eigen::Index k = 1; k < n; ++k) {
      const double z = decay[k] * mean;
      more[k] += mean * mean / mean_before * decayed_rise(z) / std::max(1.0, z) * change[k];
    }
  }
  const base::Vector way = (waves.shape * first).cwiseMax(0.0);
  const base::Vector all = way + waves.shape * more;
  std::vector<double> by;
  for (Eigen::Index i = 0; i < n; ++i) {
    by.push_back(now[i] > 0.0 ? std::clamp(all[i], least_part * way[i], largest_part * way[i])
                              : 0.0);
  }
  return by;
}

std::vector<double> FrontGrowthRates::remaining_deferred_advance(double mean) const {
  const Waves waves(static_cast<Eigen::Index>(deferred_advance.size()), kind == FrontKind::closed);
  const base::Vector dying = (-mean * waves.decay(stiffness)).array().exp();
  const base::Vector left =
      waves.shape * dying.cwiseProduct(waves.heights(vector_of(deferred_advance)));
  return {left.begin(), left.end()};
}

std::vector<double> FrontGrowthRates::uncertain_fraction() const {
  const Waves waves(static_cast<Eigen::Index>(deferred_advance.size()), kind == FrontKind::closed);
  const base::Vector part =
      waves.shape * waves.decay(stiffness).cwiseProduct(waves.heights(vector_of(deferred_advance)));
  if (kind == FrontKind::straight) {
    const base::Vector weight = vector_of(rate);
    return std::vector<double>(deferred_advance.size(), part.dot(weight) / weight.sum());
  }
  return {part.begin(), part.end()};
}

std::vector<double> smooth_front_rates(const std::vector<double>& values, FrontKind kind,
                                       double scatter) {
  if (std::ranges::any_of(values, [](double v) { return !(v > 0.0); })) {
    return values;
  }
  const base::Vector all = vector_of(values).array().log();
  const base::Vector smooth = vector_of(fitted(all, kind, rates));
  const double left = (all - smooth).norm() / std::sqrt(static_cast<double>(values.size()));
  const double true_part = left > scatter ? 1.0 - (scatter / left) * (scatter / left) : 0.0;
  const base::Vector found = (smooth + true_part * (all - smooth)).array().exp();
  return {found.begin(), found.end()};
}

std::vector<double> smooth_front_angles(const std::vector<double>& angles, FrontKind kind) {
  return fitted(vector_of(angles), kind, turns);
}

} // namespace spricka::growth
