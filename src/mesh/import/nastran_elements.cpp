// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/nastran_elements.hpp"

#include "mesh/gmsh_elements.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <array>

namespace spricka::mesh {
namespace {

using base::ElementType;

constexpr std::array<NastranElementEntry, 7> element_entries{
    {{"CTETRA", ElementType::tet4, ElementType::tet10, 4, 10, 0, false},
     {"CHEXA", ElementType::hexe8, ElementType::hexec20, 8, 20, 0, true},
     {"CPENTA", ElementType::penta6, ElementType::pentac15, 6, 15, 0, true},
     {"CQUAD4", ElementType::quam4, ElementType::quam4, 4, 4, 4, true},
     {"CQUAD8", ElementType::quam4, ElementType::quamc8, 4, 8, 4, true},
     {"CTRIA3", ElementType::trim3, ElementType::trim3, 3, 3, 3, false},
     {"CTRIA6", ElementType::trim3, ElementType::trimc6, 3, 6, 3, false}}};

// Edges of the lower side, edges along the height, edges of the upper side; here the last two are
// exchanged.
constexpr std::array<int, 20> hexahedron_order{0,  1,  2,  3,  4,  5,  6,  7,  8,  9,
                                               10, 11, 16, 17, 18, 19, 12, 13, 14, 15};
constexpr std::array<int, 15> pentahedron_order{0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 13, 14, 9, 10, 11};

// Corners of solids mirrored: the lower side runs the other way round, and so does the upper.
constexpr std::array<int, 4> mirrored_tetrahedron{0, 2, 1, 3};
constexpr std::array<int, 6> mirrored_pentahedron{0, 2, 1, 3, 5, 4};
constexpr std::array<int, 8> mirrored_hexahedron{0, 3, 2, 1, 4, 7, 6, 5};

std::span<const int> mirrored_corners(base::ReferenceDomain domain) {
  switch (domain) {
  case base::ReferenceDomain::tetrahedron:
    return mirrored_tetrahedron;
  case base::ReferenceDomain::prism:
    return mirrored_pentahedron;
  default:
    return mirrored_hexahedron;
  }
}

} // namespace

const NastranElementEntry* find_nastran_element(std::string_view name) {
  const auto* const at = std::find_if(element_entries.begin(), element_entries.end(),
                                      [&](const auto& entry) { return entry.name == name; });
  return at == element_entries.end() ? nullptr : at;
}

std::span<const int> nastran_node_order(ElementType type) {
  if (type == ElementType::hexec20) {
    return hexahedron_order;
  }
  return type == ElementType::pentac15 ? std::span<const int>(pentahedron_order)
                                       : std::span<const int>();
}

std::vector<int> mirrored_node_order(ElementType type) {
  const base::ElementInfo& info = base::element_info(type);
  if (const std::span<const int> plane = reversed_node_order(type); !plane.empty()) {
    return {plane.begin(), plane.end()};
  }
  const std::span<const int> corners = mirrored_corners(info.domain);
  std::vector<int> order(corners.begin(), corners.end());
  for (int m = 0; info.corners + m < info.nodes; ++m) {
    const auto [a, b] = shape::edge_corners(type, m);
    const int from = corners[static_cast<std::size_t>(a)];
    const int to = corners[static_cast<std::size_t>(b)];
    int same = 0;
    while (shape::edge_corners(type, same) != std::array{from, to} &&
           shape::edge_corners(type, same) != std::array{to, from}) {
      ++same;
    }
    order.push_back(info.corners + same);
  }
  return order;
}

} // namespace spricka::mesh
