// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space/hat_elements.hpp"

namespace spricka::contact {

namespace {

constexpr std::array<HatNodes, 1> edge_of_2{{{0, 1, -1}}};
constexpr std::array<HatNodes, 2> halves_of_3{{{0, 2, -1}, {2, 1, -1}}};
constexpr std::array<HatNodes, 1> corners_of_triangle{{{0, 1, 2}}};
// Along the diagonal from the first corner, as neither of the two is preferred.
constexpr std::array<HatNodes, 2> corners_of_quadrilateral{{{0, 1, 2}, {0, 2, 3}}};
constexpr std::array<HatNodes, 4> triangles_of_6{{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}}};
constexpr std::array<HatNodes, 6> triangles_of_8{
    {{0, 4, 7}, {4, 1, 5}, {5, 2, 6}, {6, 3, 7}, {4, 5, 6}, {4, 6, 7}}};
constexpr std::array<HatNodes, 8> triangles_of_9{
    {{0, 4, 8}, {4, 1, 8}, {1, 5, 8}, {5, 2, 8}, {2, 6, 8}, {6, 3, 8}, {3, 7, 8}, {7, 0, 8}}};

} // namespace

std::span<const HatNodes> hat_elements(const geometry::ElementSide& facet) {
  if (facet.is_edge()) {
    return facet.is_quadratic() ? std::span<const HatNodes>(halves_of_3) : edge_of_2;
  }
  switch (facet.nodes.size()) {
  case 6:
    return triangles_of_6;
  case 8:
    return triangles_of_8;
  case 9:
    return triangles_of_9;
  default:
    return corner_hat_elements(facet);
  }
}

std::span<const HatNodes> corner_hat_elements(const geometry::ElementSide& face) {
  if (face.corner_count() == 3) {
    return corners_of_triangle;
  }
  return corners_of_quadrilateral;
}

std::array<Vec2, 3> hat_node_local_coordinates(const geometry::ElementSide& face,
                                               const HatNodes& nodes) {
  return {face.node_local_coordinates(nodes[0]), face.node_local_coordinates(nodes[1]),
          face.node_local_coordinates(nodes[2])};
}

} // namespace spricka::contact
