// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/topology.hpp"

#include <array>
#include <cassert>

namespace spricka::shape {

namespace {

using base::ElementType;

// Nodes of each side of the richest element of a family; the poorer ones use the first few.
constexpr std::array<std::array<int, 3>, 3> triangle{{{0, 1, 3}, {1, 2, 4}, {2, 0, 5}}};
constexpr std::array<std::array<int, 3>, 4> quadrilateral{
    {{0, 1, 4}, {1, 2, 5}, {2, 3, 6}, {3, 0, 7}}};
constexpr std::array<std::array<int, 6>, 4> tetrahedron{
    {{0, 2, 1, 6, 5, 4}, {0, 1, 3, 4, 8, 7}, {1, 2, 3, 5, 9, 8}, {2, 0, 3, 6, 7, 9}}};
constexpr std::array<std::array<int, 6>, 2> wedge_ends{{{0, 2, 1, 8, 7, 6}, {3, 4, 5, 9, 10, 11}}};
constexpr std::array<std::array<int, 8>, 3> wedge_flanks{
    {{0, 1, 4, 3, 6, 13, 9, 12}, {1, 2, 5, 4, 7, 14, 10, 13}, {2, 0, 3, 5, 8, 12, 11, 14}}};
// The node in the middle of side s is 20 + s.
constexpr std::array<std::array<int, 9>, 6> hexahedron{{{0, 3, 2, 1, 11, 10, 9, 8, 20},
                                                        {4, 5, 6, 7, 12, 13, 14, 15, 21},
                                                        {0, 1, 5, 4, 8, 17, 12, 16, 22},
                                                        {1, 2, 6, 5, 9, 18, 13, 17, 23},
                                                        {2, 3, 7, 6, 10, 19, 14, 18, 24},
                                                        {3, 0, 4, 7, 11, 16, 15, 19, 25}}};

using Edge = std::array<int, 2>;
constexpr std::array<Edge, 6> tetrahedron_edges{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
constexpr std::array<Edge, 9> wedge_edges{
    {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}};
constexpr std::array<Edge, 12> hexahedron_edges{{{0, 1},
                                                 {1, 2},
                                                 {2, 3},
                                                 {3, 0},
                                                 {4, 5},
                                                 {5, 6},
                                                 {6, 7},
                                                 {7, 4},
                                                 {0, 4},
                                                 {1, 5},
                                                 {2, 6},
                                                 {3, 7}}};

// Side i of the richest element of a family.
std::span<const int> richest_side(const base::ElementInfo& info, std::size_t i) {
  switch (info.corners) {
  case 3:
    return triangle[i];
  case 4:
    return info.dim == 2 ? std::span<const int>(quadrilateral[i]) : tetrahedron[i];
  case 6:
    return i < 2 ? std::span<const int>(wedge_ends[i]) : wedge_flanks[i - 2];
  default:
    return hexahedron[i];
  }
}

} // namespace

std::span<const int> side_nodes(ElementType type, int s) {
  const base::ElementInfo& info = base::element_info(type);
  assert(s >= 0 && s < info.sides);
  const int of_edge = info.quadratic ? 3 : 2;
  const int count = info.dim == 2 ? of_edge : base::element_info(solid_side_type(type, s)).nodes;
  return richest_side(info, static_cast<std::size_t>(s)).first(static_cast<std::size_t>(count));
}

ElementType solid_side_type(ElementType type, int s) {
  const base::ElementInfo& info = base::element_info(type);
  assert(info.dim == 3);
  if (info.corners == 4 || (info.corners == 6 && s < 2)) {
    return info.quadratic ? ElementType::trimc6 : ElementType::trim3;
  }
  return type == ElementType::hexec27 ? ElementType::quamc9
         : info.quadratic             ? ElementType::quamc8
                                      : ElementType::quam4;
}

std::size_t side_corners(ElementType type, int s) {
  return base::element_info(type).dim == 2
             ? 2
             : static_cast<std::size_t>(base::element_info(solid_side_type(type, s)).corners);
}

std::array<int, 2> edge_corners(ElementType type, int m) {
  assert(m >= 0 && m < edge_count(type));
  const auto i = static_cast<std::size_t>(m);
  const base::ElementInfo& info = base::element_info(type);
  if (info.dim == 2) {
    return {m, (m + 1) % info.corners};
  }
  return info.corners == 4   ? tetrahedron_edges[i]
         : info.corners == 6 ? wedge_edges[i]
                             : hexahedron_edges[i];
}

int edge_count(ElementType type) {
  const base::ElementInfo& info = base::element_info(type);
  // a solid of plane sides: corners - edges + sides = 2 (Euler)
  return info.dim == 2 ? info.corners : info.corners + info.sides - 2;
}

} // namespace spricka::shape
