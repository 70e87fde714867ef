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

std::span<const int> wedge_side(std::size_t s, bool quadratic) {
  if (s < 2) {
    return std::span<const int>(wedge_ends[s]).first(quadratic ? 6 : 3);
  }
  return std::span<const int>(wedge_flanks[s - 2]).first(quadratic ? 8 : 4);
}

} // namespace

std::span<const int> side_nodes(ElementType type, int s) {
  assert(s >= 0 && s < base::element_info(type).sides);
  const auto i = static_cast<std::size_t>(s);
  switch (type) {
  case ElementType::trim3:
    return std::span<const int>(triangle[i]).first(2);
  case ElementType::trimc6:
    return triangle[i];
  case ElementType::quam4:
    return std::span<const int>(quadrilateral[i]).first(2);
  case ElementType::quamc8:
  case ElementType::quamc9:
    return quadrilateral[i];
  case ElementType::tet4:
    return std::span<const int>(tetrahedron[i]).first(3);
  case ElementType::tet10:
    return tetrahedron[i];
  case ElementType::penta6:
    return wedge_side(i, false);
  case ElementType::pentac15:
    return wedge_side(i, true);
  case ElementType::hexe8:
    return std::span<const int>(hexahedron[i]).first(4);
  case ElementType::hexec20:
    return std::span<const int>(hexahedron[i]).first(8);
  case ElementType::hexec27:
    return hexahedron[i];
  }
  return {};
}

ElementType solid_side_type(ElementType type, int s) {
  switch (type) {
  case ElementType::tet4:
    return ElementType::trim3;
  case ElementType::tet10:
    return ElementType::trimc6;
  case ElementType::penta6:
    return s < 2 ? ElementType::trim3 : ElementType::quam4;
  case ElementType::pentac15:
    return s < 2 ? ElementType::trimc6 : ElementType::quamc8;
  case ElementType::hexe8:
    return ElementType::quam4;
  case ElementType::hexec20:
    return ElementType::quamc8;
  default:
    assert(type == ElementType::hexec27);
    return ElementType::quamc9;
  }
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
