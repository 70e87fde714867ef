// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/adaptive_rule.hpp"

#include "fe/piecewise_rule.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace spricka::fe {

namespace {

using base::Vec3;

/// What a rule makes of a field.
template <int dim> struct RuleSums {
  Moments<dim> moments = Moments<dim>::Zero();
  double amount = 0.0;
};

template <int dim>
RuleSums<dim> sums_of(std::span<const shape::QuadraturePoint<dim>> rule,
                      const ReferenceField<dim>& value, ValueRange& seen) {
  RuleSums<dim> sums;
  for (const auto& point : rule) {
    const Vec3 v = value(point.r);
    seen.add_value(v);
    sums.moments += point_moment_contribution<dim>(point, v);
    sums.amount += point.weight * v.norm();
  }
  return sums;
}

// At so many places spread evenly over the unit cube and over each of its directions (additive
// recurrence, Roberts 2018); along a line at its ends as well. Adds them to `seen`.
template <int dim>
FieldOutlier outlier_of(const AdaptiveDomain<dim>& domain, const ReferenceField<dim>& value,
                        ValueRange& seen, double scale, int places) {
  constexpr double inside = 1e-6;
  constexpr std::array<double, 2> step = adaptive_rule_limits<dim>.recurrence;
  std::vector<std::pair<UnitPoint, Vec3>> looks;
  const auto look = [&](const UnitPoint& t) { looks.emplace_back(t, value(domain.map(t).r)); };
  for (int i = 0; i < places; ++i) {
    const double first = step[0] * (i + 1);
    const double second = step[1] * (i + 1);
    look({(i + 0.5) / places, first - std::floor(first), second - std::floor(second)});
  }
  if constexpr (adaptive_rule_limits<dim>.ends) {
    look({inside, 0.0, 0.0});
    look({1.0 - inside, 0.0, 0.0});
  }
  Vec3 mean = Vec3::Zero();
  for (const auto& [t, v] : looks) {
    mean += v / static_cast<double>(looks.size());
  }
  FieldOutlier most;
  double unlike = -1.0;
  for (const auto& [t, v] : looks) {
    const double excess = seen.excess(v, scale);
    const double off = (v - mean).norm();
    if (excess > most.excess || (excess == most.excess && off > unlike)) {
      most = {excess, t};
      unlike = off;
    }
  }
  for (const auto& [t, v] : looks) {
    seen.add_value(v);
  }
  return most;
}

} // namespace

template <int dim>
FieldAdaptedRule<dim> make_adapted_rule(const AdaptiveDomain<dim>& domain,
                                        const ReferenceField<dim>& value,
                                        const AdaptiveSettings& settings) {
  const int places =
      settings.smooth ? adaptive_rule_limits<1>.places : adaptive_rule_limits<dim>.places;
  const double between = 1.0 / places; // the part of an element that a place tells of
  ValueRange seen;
  const RuleSums<dim> usual = sums_of<dim>(domain.usual, value, seen);
  const RuleSums<dim> finer = sums_of<dim>(domain.finer, value, seen);
  const double error = (usual.moments - finer.moments).cwiseAbs().maxCoeff();
  double size = 0.0;
  for (const auto& point : domain.usual) {
    size += point.weight;
  }
  const double largest = std::max(settings.scale.largest, seen.largest);
  const FieldOutlier outlier = outlier_of<dim>(domain, value, seen, largest, places);
  const double amount = std::max(
      {size * settings.scale.mean, usual.amount, finer.amount, between * size * outlier.excess});
  const double usual_enough = settings.smooth ? adaptive_rule_limits<dim>.usual_enough : 0.0;
  const bool agreed = error <= std::max(settings.tolerance, usual_enough) * amount;
  if (!std::isfinite(error) || (agreed && outlier.excess == 0.0)) {
    return {{domain.usual.begin(), domain.usual.end()}, 0.0, finer.amount, false};
  }
  if (settings.smooth && outlier.excess == 0.0 &&
      error <= adaptive_rule_limits<dim>.finer_enough * amount) {
    return {{domain.finer.begin(), domain.finer.end()}, 0.0, finer.amount, false};
  }
  PiecewiseRule<dim> pieces(domain, value, settings, amount, outlier);
  FieldAdaptedRule<dim> rule = pieces.build_rule();
  // what no piece has found of all that was seen is told
  const double left = std::max(pieces.value_range().excess(seen.low, seen.largest),
                               pieces.value_range().excess(seen.high, seen.largest));
  rule.missed += between * size * left;
  return rule;
}

#define ADAPTED_RULE(dim)                                                                          \
  template FieldAdaptedRule<dim> make_adapted_rule<dim>(                                           \
      const AdaptiveDomain<dim>&, const ReferenceField<dim>&, const AdaptiveSettings&);
ADAPTED_RULE(1)
ADAPTED_RULE(2)
ADAPTED_RULE(3)

} // namespace spricka::fe
