// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/smooth_front.hpp"

#include "base/dense_solve.hpp"
#include "shape/quadrature.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::crack {

namespace {

constexpr Eigen::Index order = 4; // of a cubic spline

// B-splines that are not zero at s, of the knots t[first .. first + 2 order - 3] (de Boor 1978, X).
Eigen::Vector4d basis_at(const std::vector<double>& t, std::size_t interval, double s) {
  Eigen::Vector4d b = Eigen::Vector4d::Zero();
  b[0] = 1.0;
  for (int k = 1; k < order; ++k) {
    double carried = 0.0;
    for (int j = 0; j < k; ++j) {
      const double right = t[interval + static_cast<std::size_t>(j) + 1];
      const double left =
          t[interval + static_cast<std::size_t>(j) + 1 - static_cast<std::size_t>(k)];
      const double part = b[j] / (right - left);
      b[j] = carried + (right - s) * part;
      carried = (s - left) * part;
    }
    b[k] = carried;
  }
  return b;
}

// Knots with three more on each side: of a closed front the same again, else the ends repeated.
std::vector<double> knots_of(const FrontStations& at) {
  std::vector<double> inner;
  const std::size_t count = at.s.size();
  for (std::size_t i = 0; i < count; i += 2) {
    inner.push_back(at.s[i]);
  }
  if (at.closed) {
    if (count % 2 == 1 && inner.size() > 1) {
      inner.pop_back(); // the last piece would be half as long
    }
    inner.push_back(at.s.front() + at.length);
  } else {
    inner.back() = at.s.back();
  }
  std::vector<double> knots;
  const std::size_t pieces = inner.size() - 1;
  for (std::size_t k = 0; k < 3; ++k) {
    knots.push_back(at.closed ? inner[(pieces * 3 + k - 3) % pieces] - at.length : inner.front());
  }
  knots.insert(knots.end(), inner.begin(), inner.end());
  for (std::size_t k = 1; k <= 3; ++k) {
    knots.push_back(at.closed ? inner[k % pieces] + at.length : inner.back());
  }
  return knots;
}

} // namespace

namespace {

// The splines of a front as functions of s.
class Splines {
public:
  explicit Splines(const FrontStations& at) : knots_(knots_of(at)), closed_(at.closed) {}

  [[nodiscard]] Eigen::Index count() const {
    return static_cast<Eigen::Index>(closed_ ? pieces() : pieces() + 3);
  }
  // Adds part times their values at s to a row.
  void add(double s, double part, base::Matrix& rows, Eigen::Index row) const {
    const auto begin = knots_.begin() + 3;
    const auto above = std::upper_bound(begin, begin + static_cast<std::ptrdiff_t>(pieces()), s);
    const auto interval =
        std::max<std::size_t>(static_cast<std::size_t>(above - knots_.begin()) - 1, 3);
    const Eigen::Vector4d b = basis_at(knots_, interval, s);
    for (Eigen::Index k = 0; k < order; ++k) {
      rows(row, (static_cast<Eigen::Index>(interval) - 3 + k) % count()) += part * b[k];
    }
  }

private:
  [[nodiscard]] std::size_t pieces() const { return knots_.size() - 7; }

  std::vector<double> knots_;
  bool closed_;
};

// Means of the splines over each point's hat, with the same points as the values are means.
base::Matrix hat_means(const FrontStations& at, const Splines& splines) {
  const std::size_t count = at.s.size();
  base::Matrix means = base::Matrix::Zero(static_cast<Eigen::Index>(count), splines.count());
  std::vector<double> whole(count, 0.0);
  for (std::size_t i = 0; i + 1 < count + (at.closed ? 1 : 0); ++i) {
    const std::size_t next = (i + 1) % count;
    const double width = (next == 0 ? at.s.front() + at.length : at.s[next]) - at.s[i];
    for (const auto& point : shape::line_rule(5)) {
      const double part = 0.5 * (1.0 + point.r[0]);
      for (const auto& [to, hat] : {std::pair(i, 1.0 - part), std::pair(next, part)}) {
        const double weight = 0.5 * width * point.weight * hat;
        splines.add(at.s[i] + part * width, weight, means, static_cast<Eigen::Index>(to));
        whole[to] += weight;
      }
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    means.row(static_cast<Eigen::Index>(i)) /= whole[i];
  }
  return means;
}

} // namespace

// K of a point is the mean over its hat: the spline gives back what that has smeared.
base::Matrix smooth_values_along_front(const FrontStations& at, const base::Matrix& values) {
  const auto counting = std::ranges::count_if(at.weight, [](double w) { return w > 0.0; });
  // A closed front needs four pieces, so that no spline meets itself.
  if (counting < 5 || (at.closed && at.s.size() < 8)) {
    return values;
  }
  const Splines splines(at);
  base::Matrix B = base::Matrix::Zero(static_cast<Eigen::Index>(at.s.size()), splines.count());
  base::Matrix left = hat_means(at, splines);
  base::Matrix right = values;
  for (std::size_t i = 0; i < at.s.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    splines.add(at.s[i], 1.0, B, row);
    if (!at.local.empty() && at.local[i]) {
      left.row(row) = B.row(row);
    }
    left.row(row) *= std::sqrt(at.weight[i]);
    right.row(row) *= std::sqrt(at.weight[i]);
  }
  // Where points without a value leave a spline undetermined the smallest coefficients are taken.
  return B * left.completeOrthogonalDecomposition().solve(right);
}

namespace {

// What each of the values at distances d, ascending, counts in the parabola at 0; in a line where
// there are fewer than four.
base::Vector weights_at_zero(const std::vector<double>& d) {
  const auto n = static_cast<Eigen::Index>(d.size());
  base::Matrix powers(n, d.size() < 4 ? 2 : 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double x = d[static_cast<std::size_t>(i)] / d.back();
    for (Eigen::Index k = 0; k < powers.cols(); ++k) {
      powers(i, k) = k == 0 ? 1.0 : powers(i, k - 1) * x;
    }
  }
  const base::Matrix inverse =
      base::least_squares(powers, base::Matrix(base::Matrix::Identity(n, n)));
  return inverse.row(0);
}

} // namespace

std::optional<base::Vector> extrapolate_front_value(const FrontStations& at,
                                                    const base::Matrix& values,
                                                    const ExtrapolationRange& beside) {
  constexpr std::size_t fewest = 5;
  constexpr std::size_t most = 9;
  constexpr double counted = 1.5; // times an error of the values
  std::vector<std::pair<double, Eigen::Index>> points;
  for (std::size_t i = 0; i < at.s.size(); ++i) {
    if (at.weight[i] > 0.0) {
      points.emplace_back(std::abs(at.s[i] - beside.s), static_cast<Eigen::Index>(i));
    }
  }
  std::ranges::sort(points);
  if (points.size() < 2) {
    return std::nullopt;
  }
  std::vector<double> distance;
  base::Vector weights;
  const auto is_enough = [&] {
    const std::size_t n = distance.size();
    return n == points.size() || n == most ||
           (n >= fewest && points[n].first > beside.far && weights.norm() <= counted);
  };
  while (!is_enough()) {
    distance.push_back(points[distance.size()].first);
    if (distance.size() > 1) {
      weights = weights_at_zero(distance);
    }
  }
  base::Vector value = base::Vector::Zero(values.cols());
  for (Eigen::Index k = 0; k < weights.size(); ++k) {
    value += weights[k] * values.row(points[static_cast<std::size_t>(k)].second).transpose();
  }
  return value;
}

} // namespace spricka::crack
