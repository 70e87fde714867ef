// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/element.hpp"

#include <vector>

namespace spricka::fe {

inline constexpr int chart_degree = 7; ///< 4 x 4 points

/// A part of a plane reference element as the image of the square 0 <= a, b <= 1. A collapsed one
/// is a triangle with the side a = 0 in its first corner: roots of the distance from that corner
/// are smooth in a, in quarter-point elements as well (Duffy 1982).
struct ReferenceChart {
  shape::Point<2> corner, along, across; ///< collapsed: the other two corners less the first
  bool collapsed = false;

  /// The point of the reference element that (a, b) of the square is mapped to.
  [[nodiscard]] shape::Point<2> reference_point(double a, double b) const {
    return collapsed ? shape::Point<2>(corner + a * ((1.0 - b) * along + b * across))
                     : shape::Point<2>(corner + a * along + b * across);
  }
  /// Area of the reference element per that of the square.
  [[nodiscard]] double area_ratio(double a) const {
    const double whole = along.x() * across.y() - along.y() * across.x();
    return collapsed ? a * whole : whole;
  }
};

/// The corner of an element that is one of some nodes; -1: none.
inline int find_tip_corner(const model::Mesh& mesh, base::ElementId e,
                           std::span<const base::NodeId> tips) {
  const std::span<const base::NodeId> nodes = mesh.element_nodes(e);
  for (int c = 0; c < base::element_info(mesh.type[e.index()]).corners; ++c) {
    if (std::ranges::find(tips, nodes[static_cast<std::size_t>(c)]) != tips.end()) {
      return c;
    }
  }
  return -1;
}

/// Charts of an element, collapsed into the corner `tip`; -1: nothing is singular.
inline std::vector<ReferenceChart> reference_charts(const AnyElement<2>& element, int tip) {
  const int corners = element.corners;
  const auto at = [&](int i) { return element.node_local_coordinates(i % corners); };
  if (corners == 4 && tip < 0) {
    return {{at(0), at(1) - at(0), at(3) - at(0), false}};
  }
  const int c = std::max(tip, 0);
  std::vector<ReferenceChart> result{{at(c), at(c + 1) - at(c), at(c + 2) - at(c), true}};
  if (corners == 4) {
    result.push_back({at(c), at(c + 2) - at(c), at(c + 3) - at(c), true});
  }
  return result;
}

/// Calls visit(r, weight) at the points of a product rule of some degree on the part [a, a + h] x
/// [b, b + h] of a chart.
template <class Visit>
void for_chart_points(const ReferenceChart& chart, const base::Vec3& cell, Visit&& visit,
                      int degree = chart_degree) {
  const double h = cell[2];
  for (const auto& p : shape::line_rule(degree)) {
    const double a = cell[0] + 0.5 * h * (1.0 + p.r[0]);
    for (const auto& q : shape::line_rule(degree)) {
      const double b = cell[1] + 0.5 * h * (1.0 + q.r[0]);
      visit(chart.reference_point(a, b), 0.25 * h * h * p.weight * q.weight * chart.area_ratio(a));
    }
  }
}

} // namespace spricka::fe
