// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "geometry/element_side.hpp"
#include "shape/quadrature.hpp"

#include <array>
#include <span>

/// Facets, sides of elements, as contact sees them: cut into pieces between their nodes.
namespace spricka::contact {

using base::Vec2;
using base::Vec3;

/// Nodes of a facet: of a face three, round the way its corners go; of an edge two along it, and
/// -1.
using HatNodes = std::array<int, 3>;
/// A facet cut into pieces on which hats are linear. An edge by its number of nodes: 2 1, 3 2
/// halves; a face into triangles: 3 1, 4 2, 6 4, 8 6, 9 8. Each node is an end or a corner of some,
/// so that hats on them are one function for each node.
std::span<const HatNodes> hat_elements(const geometry::ElementSide& facet);
/// The same between the corners of a face only: 1 or 2.
std::span<const HatNodes> corner_hat_elements(const geometry::ElementSide& face);

/// Calls f(hats, r, weight) for the points of the rule of some degree on a piece of a facet: the
/// hats of its nodes and the place on the facet there, the weight in the facet's local coordinates.
template <class F>
void visit_hat_quadrature_points(const geometry::ElementSide& facet, const HatNodes& nodes,
                                 int degree, F&& f) {
  const Vec2 first = facet.node_local_coordinates(nodes[0]);
  const Vec2 a = facet.node_local_coordinates(nodes[1]) - first;
  if (facet.is_edge()) {
    for (const auto& [r, weight] : shape::line_rule(degree)) {
      const double part = 0.5 * (1.0 + r[0]);
      f(Vec3(1.0 - part, part, 0.0), Vec2(first + part * a), 0.5 * a.x() * weight);
    }
    return;
  }
  const Vec2 b = facet.node_local_coordinates(nodes[2]) - first;
  const double area2 = a.x() * b.y() - a.y() * b.x();
  for (const auto& [q, weight] : shape::triangle_rule(degree)) {
    f(Vec3(1.0 - q[0] - q[1], q[0], q[1]), Vec2(first + q[0] * a + q[1] * b), weight * area2);
  }
}

/// Local coordinates of three nodes of a face.
std::array<Vec2, 3> hat_node_local_coordinates(const geometry::ElementSide& face,
                                               const HatNodes& nodes);

} // namespace spricka::contact
