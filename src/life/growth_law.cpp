// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/growth_law.hpp"

#include "life/no_value.hpp"
#include "life/root.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace spricka::life {

using model::CrackGrowthLaw;
using model::GrowthLawConstants;

namespace {

constexpr double k_infinite = std::numeric_limits<double>::infinity();

// C for K and lengths in the units of the deck: the powers of k_unit that a law divides by are
// taken into it, and its formula takes K as it is. Forman's has one power less, as it divides by K
// once.
double scaled_constant(CrackGrowthLaw law, const GrowthLawConstants& constants) {
  const double power = law == CrackGrowthLaw::forman ? constants.m - 1.0 : constants.m;
  return constants.C * constants.a_unit / std::pow(constants.k_unit, power);
}

// y at x on the polyline through (knot, value), straight on beyond its ends.
double on_polyline(const std::vector<double>& knot, const std::vector<double>& value, double x) {
  const auto above = std::upper_bound(knot.begin() + 1, knot.end() - 1, x);
  const auto i = static_cast<std::size_t>(above - knot.begin());
  const double t = (x - knot[i - 1]) / (knot[i] - knot[i - 1]);
  return value[i - 1] + t * (value[i] - value[i - 1]);
}

} // namespace

double tensile_K_range(double K_max, double K_min) {
  return K_max - std::max(K_min, 0.0);
}

GrowthRateLaw::GrowthRateLaw(CrackGrowthLaw law, GrowthLawConstants constants)
    : law_(law), constants_(std::move(constants)), scale_(scaled_constant(law, constants_)),
      closure_(constants_.alpha, constants_.stress_ratio), threshold_(constants_) {
  assert((law != CrackGrowthLaw::forman && law != CrackGrowthLaw::nasgro &&
          law != CrackGrowthLaw::hartman) ||
         constants_.k_c);
  assert(law != CrackGrowthLaw::table ||
         (constants_.delta_k.size() >= 2 && constants_.growth.size() == constants_.delta_k.size()));
  for (std::size_t i = 0; law == CrackGrowthLaw::table && i < constants_.delta_k.size(); ++i) {
    log_k_.push_back(std::log(constants_.delta_k[i] * constants_.k_unit));
    log_rate_.push_back(std::log(constants_.growth[i] * constants_.a_unit));
  }
}

double GrowthRateLaw::counted_ratio(double R) const {
  const bool counts_below =
      law_ == CrackGrowthLaw::nasgro ||
      (law_ == CrackGrowthLaw::walker &&
       constants_.at_negative_ratio != model::NegativeRatioRule::positive_part);
  return counts_below ? R : std::max(R, 0.0);
}

// (life.4), (life.29): delta K of (life.1) times (1 - R)^exponent is that of R = 0.
double GrowthRateLaw::walker_exponent(double R) const {
  if (R >= 0.0) {
    return constants_.p - 1.0;
  }
  switch (constants_.at_negative_ratio) {
  case model::NegativeRatioRule::whole_range:
    return constants_.p_below; // (1 - R) K_max / (1 - R)^(1 - p_below)
  case model::NegativeRatioRule::K_max:
    return constants_.p - 1.0;
  case model::NegativeRatioRule::positive_part:
    break;
  }
  return 0.0;
}

double GrowthRateLaw::threshold(double R, const model::PlaceOnCrack& place) const {
  const double counted = counted_ratio(R);
  const double all = threshold_(counted, place.a);
  // (life.25) is one of K_max - K_min, of which the part above K = 0 is left.
  return threshold_.varies() && counted < 0.0 ? all / (1.0 - counted) : all;
}

bool GrowthRateLaw::is_held_by_constant_threshold(double K_max, double K_min) const {
  constexpr double much = 2.0;  // of the threshold: up to there NASGRO's end term counts
  constexpr double same = 0.05; // R
  const double range = tensile_K_range(K_max, K_min);
  // The constant in Hartman and Schijve's law is one of all R.
  if (law_ == CrackGrowthLaw::hartman || !has_constant_threshold() || !(range > 0.0) ||
      std::abs(counted_ratio(K_min / K_max)) <= same) {
    return false;
  }
  const bool fades = law_ == CrackGrowthLaw::nasgro && constants_.p > 0.0;
  return range <= (fades ? much : 1.0) * constants_.threshold;
}

double GrowthRateLaw::growth_rate(double K_max, double K_min,
                                  const model::PlaceOnCrack& place) const {
  const double range = tensile_K_range(K_max, K_min);
  if (!(range > 0.0) || !(K_max > 0.0)) {
    return std::isnan(range) ? no_value : 0.0;
  }
  const double R = K_min / K_max;
  const double least = threshold(R, place);
  return range > least ? formula(range, R, least, place) : 0.0;
}

// range above the threshold; R < 1, below 0 too.
double GrowthRateLaw::formula(double range, double R, double threshold,
                              const model::PlaceOnCrack& place) const {
  const double part = 1.0 - std::max(R, 0.0); // range / K_max
  switch (law_) {
  case CrackGrowthLaw::increment:
  case CrackGrowthLaw::paris:
    return scale_ * std::pow(range, constants_.m);
  case CrackGrowthLaw::walker:
    return scale_ * std::pow(range * std::pow(1.0 - R, walker_exponent(R)), constants_.m);
  case CrackGrowthLaw::forman: {
    // (life.5). The pole is where K_max reaches the toughness; beyond it the rate stays infinite,
    // not negative.
    const double left = part * toughness_at(place) - range;
    return left > 0.0 ? scale_ * std::pow(range, constants_.m) / left : k_infinite;
  }
  case CrackGrowthLaw::nasgro: {
    const double K_max = range / part;
    const double left = 1.0 - K_max / toughness_at(place);
    if (!(left > 0.0)) {
      return k_infinite;
    }
    // (life.6), in which (K_max - K_min) / (1 - R) is K_max whatever the sign of R.
    return scale_ * std::pow((1.0 - closure_(R)) * K_max, constants_.m) *
           std::pow(1.0 - threshold / range, constants_.p) / std::pow(left, constants_.q);
  }
  case CrackGrowthLaw::table:
    return tabular(range);
  case CrackGrowthLaw::hartman: {
    const double left = 1.0 - range / part / toughness_at(place);
    return left > 0.0 ? scale_ * std::pow((range - threshold) / std::sqrt(left), constants_.m)
                      : k_infinite; // (life.28)
  }
  }
  return no_value;
}

double GrowthRateLaw::tabular(double range) const {
  return std::exp(on_polyline(log_k_, log_rate_, std::log(range)));
}

double GrowthRateLaw::tabular_range(double rate) const {
  return std::exp(on_polyline(log_rate_, log_k_, std::log(rate)));
}

// Laws with a pole rise from the threshold (or 0) to the pole at the toughness: one root between.
double GrowthRateLaw::by_root(double rate, double R, double threshold,
                              const model::PlaceOnCrack& place) const {
  const double end = std::log((1.0 - std::max(R, 0.0)) * toughness_at(place));
  const auto excess = [&](double log_range) {
    const double there = formula(std::exp(log_range), R, threshold, place);
    return there > 0.0 ? std::log(there / rate) : -k_infinite;
  };
  // Without a threshold the rate falls to zero with delta K: looked for downwards, twice as far in
  // the logarithm each time.
  double begin = threshold > 0.0 ? std::log(threshold) : end - 1.0;
  for (double reach = 1.0; threshold <= 0.0 && !(excess(begin) < 0.0); reach *= 2.0) {
    if (reach > 1e3) {
      return no_value;
    }
    begin = end - reach;
  }
  const std::optional<double> root = root_of_increasing_function(excess, begin, end);
  return root ? std::exp(*root) : no_value;
}

double GrowthRateLaw::K_range_for_rate(double rate, double R,
                                       const model::PlaceOnCrack& place) const {
  if (!(rate > 0.0) || !(R < 1.0) || std::isinf(rate)) {
    return no_value;
  }
  const double least = threshold(R, place);
  double found = no_value;
  switch (law_) {
  case CrackGrowthLaw::increment:
  case CrackGrowthLaw::paris:
    found = std::pow(rate / scale_, 1.0 / constants_.m);
    break;
  case CrackGrowthLaw::walker:
    found = std::pow(rate / scale_, 1.0 / constants_.m) * std::pow(1.0 - R, -walker_exponent(R));
    break;
  case CrackGrowthLaw::table:
    // Rates that do not rise all the way have several ranges, or none.
    found = std::is_sorted(log_rate_.begin(), log_rate_.end(), std::less_equal<>())
                ? tabular_range(rate)
                : no_value;
    break;
  case CrackGrowthLaw::forman:
  case CrackGrowthLaw::nasgro:
  case CrackGrowthLaw::hartman:
    found = by_root(rate, R, least, place);
    break;
  }
  return found > least ? found : no_value;
}

std::optional<std::array<double, 2>> GrowthRateLaw::table_K_range() const {
  if (law_ != CrackGrowthLaw::table) {
    return std::nullopt;
  }
  return std::array{std::exp(log_k_.front()), std::exp(log_k_.back())};
}

bool GrowthRateLaw::is_within_table(double delta_K) const {
  if (law_ != CrackGrowthLaw::table) {
    return true;
  }
  // a row's own delta K, converted and back, still belongs to the table
  const double room = 1e-12;
  const double x = std::log(delta_K);
  return x >= log_k_.front() - room && x <= log_k_.back() + room;
}

} // namespace spricka::life
