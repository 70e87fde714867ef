// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/heat_points.hpp"

#include "fe/corner_rule.hpp"
#include "fe/load_rule.hpp"

#include <cmath>

namespace spricka::fe {

namespace {

// Products of a line's rule over a chart.
std::vector<shape::QuadraturePoint<2>> chart_rule(const ReferenceChart& chart, int degree) {
  std::vector<shape::QuadraturePoint<2>> rule;
  for_chart_points(
      chart, {0.0, 0.0, 1.0},
      [&](const shape::Point<2>& r, double weight) {
        rule.push_back({r, weight});
      },
      degree);
  return rule;
}

} // namespace

SampledTemperature sample_temperature(const AnyElement<2>& element, const AnyNodeVectors<2>& X,
                                      const TemperatureField& field, base::ElementId e,
                                      const FieldMagnitude& scale, int tip) {
  constexpr int finer_degree = 15;
  const auto value = [&](const shape::Point<2>& r) {
    return base::Vec3(field(e, base::Vec2(X * element.N(r))), 0.0, 0.0);
  };
  SampledTemperature sampled;
  for (const ReferenceChart& chart : reference_charts(element, tip)) {
    const auto map = [&](const UnitPoint& t) {
      shape::QuadraturePoint<2> p;
      p.r = chart.reference_point(t[0], t[1]);
      p.weight = chart.area_ratio(t[0]);
      return p;
    };
    const auto usual = chart_rule(chart, chart_degree);
    const auto finer = chart_rule(chart, finer_degree);
    const FieldAdaptedRule<2> rule = make_adapted_rule<2>(
        {map, usual, finer}, value, {adaptive_rule_limits<2>.load_tolerance, scale, false});
    double area = 0.0;
    double reference_area = 0.0;
    for (const auto& point : rule.points) {
      const double det = Eigen::Matrix2d(X.lazyProduct(element.dN(point.r))).determinant();
      ResidualTemperaturePoint& at = sampled.points.emplace_back();
      at.element = e;
      at.r = point.r;
      at.area = point.weight * det;
      at.T = value(point.r)[0];
      area += point.weight * det;
      reference_area += point.weight;
    }
    sampled.discontinuous = sampled.discontinuous || rule.jumps;
    sampled.amount += rule.amount * area / reference_area;
    sampled.missed += rule.missed * area / reference_area;
  }
  return sampled;
}

} // namespace spricka::fe
