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

} // namespace

double tensile_K_range(double K_max, double K_min) {
  return K_max - std::max(K_min, 0.0);
}

GrowthRateLaw::GrowthRateLaw(CrackGrowthLaw law, GrowthLawConstants constants)
    : law_(law), constants_(std::move(constants)), scale_(scaled_constant(law, constants_)),
      closure_(constants_.alpha, constants_.stress_ratio), threshold_(constants_),
      table_(constants_) {
  assert((law != CrackGrowthLaw::forman && law != CrackGrowthLaw::nasgro &&
          law != CrackGrowthLaw::hartman) ||
         constants_.k_c);
  assert(law != CrackGrowthLaw::table ||
         (constants_.growth.size() >= 2 &&
          constants_.delta_k.size() ==
              constants_.growth.size() * std::max<std::size_t>(1, constants_.table_ratios.size())));
}

double GrowthRateLaw::counted_ratio(double R) const {
  const bool counts_below =
      law_ == CrackGrowthLaw::nasgro ||
      (law_ == CrackGrowthLaw::table && table_.has_negative_ratio()) ||
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
    return table_.rate(range, R);
  case CrackGrowthLaw::hartman: {
    const double left = 1.0 - range / part / toughness_at(place);
    return left > 0.0 ? scale_ * std::pow((range - threshold) / std::sqrt(left), constants_.m)
                      : k_infinite; // (life.28)
  }
  }
  return no_value;
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
    found = table_.K_range(rate, R);
    break;
  case CrackGrowthLaw::forman:
  case CrackGrowthLaw::nasgro:
  case CrackGrowthLaw::hartman:
    found = by_root(rate, R, least, place);
    break;
  }
  return found > least ? found : no_value;
}

std::optional<std::array<double, 2>> GrowthRateLaw::table_K_range(double R) const {
  return law_ == CrackGrowthLaw::table ? std::optional(table_.K_ends(R)) : std::nullopt;
}

std::optional<std::array<double, 2>> GrowthRateLaw::table_ratios() const {
  return law_ == CrackGrowthLaw::table && !table_.ratios().empty()
             ? std::optional(std::array{table_.ratios().front(), table_.ratios().back()})
             : std::nullopt;
}

bool GrowthRateLaw::is_within_table(double delta_K, double R) const {
  constexpr double room = 1e-12; // a row's own delta K, converted and back, still belongs to it
  const std::optional<std::array<double, 2>> ends = table_K_range(R);
  return !ends || (delta_K >= (*ends)[0] * (1.0 - room) && delta_K <= (*ends)[1] * (1.0 + room));
}

} // namespace spricka::life
