// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/topology.hpp"

#include <array>
#include <cassert>

namespace spricka::shape {

namespace {

using base::ElementType;
using base::ReferenceDomain;

/// A side and its nodes in the richest element of a family; the poorer ones use the first few.
struct DomainSide {
  ReferenceDomain domain;
  std::array<int, 9> nodes;
};
constexpr auto line = ReferenceDomain::line;
constexpr auto triangle = ReferenceDomain::triangle;
constexpr auto quadrilateral = ReferenceDomain::quadrilateral;

constexpr std::array<DomainSide, 3> triangle_sides{
    {{line, {0, 1, 3}}, {line, {1, 2, 4}}, {line, {2, 0, 5}}}};
constexpr std::array<DomainSide, 4> quadrilateral_sides{
    {{line, {0, 1, 4}}, {line, {1, 2, 5}}, {line, {2, 3, 6}}, {line, {3, 0, 7}}}};
constexpr std::array<DomainSide, 4> tetrahedron_sides{{{triangle, {0, 2, 1, 6, 5, 4}},
                                                       {triangle, {0, 1, 3, 4, 8, 7}},
                                                       {triangle, {1, 2, 3, 5, 9, 8}},
                                                       {triangle, {2, 0, 3, 6, 7, 9}}}};
constexpr std::array<DomainSide, 5> prism_sides{{{triangle, {0, 2, 1, 8, 7, 6}},
                                                 {triangle, {3, 4, 5, 9, 10, 11}},
                                                 {quadrilateral, {0, 1, 4, 3, 6, 13, 9, 12}},
                                                 {quadrilateral, {1, 2, 5, 4, 7, 14, 10, 13}},
                                                 {quadrilateral, {2, 0, 3, 5, 8, 12, 11, 14}}}};
// The node in the middle of side s is 20 + s.
constexpr std::array<DomainSide, 6> hexahedron_sides{
    {{quadrilateral, {0, 3, 2, 1, 11, 10, 9, 8, 20}},
     {quadrilateral, {4, 5, 6, 7, 12, 13, 14, 15, 21}},
     {quadrilateral, {0, 1, 5, 4, 8, 17, 12, 16, 22}},
     {quadrilateral, {1, 2, 6, 5, 9, 18, 13, 17, 23}},
     {quadrilateral, {2, 3, 7, 6, 10, 19, 14, 18, 24}},
     {quadrilateral, {3, 0, 4, 7, 11, 16, 15, 19, 25}}}};

using Edge = std::array<int, 2>;
constexpr std::array<Edge, 1> line_edges{{{0, 1}}};
constexpr std::array<Edge, 3> triangle_edges{{{0, 1}, {1, 2}, {2, 0}}};
constexpr std::array<Edge, 4> quadrilateral_edges{{{0, 1}, {1, 2}, {2, 3}, {3, 0}}};
constexpr std::array<Edge, 6> tetrahedron_edges{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
constexpr std::array<Edge, 9> prism_edges{
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

struct DomainTopology {
  std::size_t corners;
  std::span<const Edge> edges;
  std::span<const DomainSide> sides;
};
// By the domain.
constexpr std::array<DomainTopology, 6> topologies{{{2, line_edges, {}},
                                                    {3, triangle_edges, triangle_sides},
                                                    {4, quadrilateral_edges, quadrilateral_sides},
                                                    {4, tetrahedron_edges, tetrahedron_sides},
                                                    {6, prism_edges, prism_sides},
                                                    {8, hexahedron_edges, hexahedron_sides}}};

const DomainTopology& topology_of(ReferenceDomain domain) {
  return topologies[static_cast<std::size_t>(domain)];
}
const DomainTopology& topology_of(ElementType type) {
  return topology_of(base::element_info(type).domain);
}

const DomainSide& crack_face_of_element_side(ElementType type, int s) {
  assert(s >= 0 && s < base::element_info(type).sides);
  return topology_of(type).sides[static_cast<std::size_t>(s)];
}

} // namespace

std::span<const int> side_nodes(ElementType type, int s) {
  const DomainSide& side = crack_face_of_element_side(type, s);
  const DomainTopology& own = topology_of(side.domain);
  const std::size_t between = base::element_info(type).quadratic ? own.edges.size() : 0;
  const std::size_t centre = type == ElementType::hexec27 ? 1 : 0;
  return std::span(side.nodes).first(own.corners + between + centre);
}

ReferenceDomain side_domain(ElementType type, int s) {
  return crack_face_of_element_side(type, s).domain;
}

ElementType solid_side_type(ElementType type, int s) {
  const base::ElementInfo& info = base::element_info(type);
  assert(side_domain(type, s) != line);
  if (side_domain(type, s) == triangle) {
    return info.quadratic ? ElementType::trimc6 : ElementType::trim3;
  }
  return type == ElementType::hexec27 ? ElementType::quamc9
         : info.quadratic             ? ElementType::quamc8
                                      : ElementType::quam4;
}

std::size_t side_corner_count(ElementType type, int s) {
  return topology_of(side_domain(type, s)).corners;
}

std::size_t side_edge_count(ElementType type, int s) {
  return topology_of(side_domain(type, s)).edges.size();
}

std::array<int, 2> edge_corners(ElementType type, int m) {
  assert(m >= 0 && m < edge_count(type));
  return topology_of(type).edges[static_cast<std::size_t>(m)];
}

int edge_count(ElementType type) {
  return static_cast<int>(topology_of(type).edges.size());
}

} // namespace spricka::shape
