// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/gmsh_elements.hpp"

#include <algorithm>

namespace spricka::mesh {
namespace {

using base::ElementType;

constexpr std::array<int, 10> tet10{0, 1, 2, 3, 4, 5, 6, 7, 9, 8};
constexpr std::array<int, 15> pentac15{0, 1, 2, 3, 4, 5, 6, 9, 7, 12, 14, 13, 8, 10, 11};
constexpr std::array<int, 27> hexe{0,  1,  2,  3,  4,  5,  6,  7,  8,  11, 13, 9,  16, 18,
                                   19, 17, 10, 12, 14, 15, 20, 25, 21, 23, 24, 22, 26};

constexpr std::array<GmshElementType, 12> table{{
    {2, ElementType::trim3, {}},
    {9, ElementType::trimc6, {}},
    {3, ElementType::quam4, {}},
    {16, ElementType::quamc8, {}},
    {10, ElementType::quamc9, {}},
    {4, ElementType::tet4, {}},
    {11, ElementType::tet10, tet10},
    {6, ElementType::penta6, {}},
    {18, ElementType::pentac15, pentac15},
    {5, ElementType::hexe8, {}},
    {17, ElementType::hexec20, std::span<const int>(hexe).first(20)},
    {12, ElementType::hexec27, hexe},
}};

constexpr std::array<int, 6> over_triangle{0, 2, 1, 5, 4, 3};
constexpr std::array<int, 9> over_quadrilateral{0, 3, 2, 1, 7, 6, 5, 4, 8};

} // namespace

std::optional<GmshElementType> find_gmsh_element_type(int number) {
  const auto* const at = std::find_if(table.begin(), table.end(),
                                      [&](const GmshElementType& e) { return e.number == number; });
  if (at == table.end()) {
    return std::nullopt;
  }
  return *at;
}

std::span<const int> reversed_node_order(ElementType type) {
  const base::ElementInfo& info = base::element_info(type);
  const auto nodes = static_cast<std::size_t>(info.nodes);
  switch (info.domain) {
  case base::ReferenceDomain::triangle:
    return std::span<const int>(over_triangle).first(nodes);
  case base::ReferenceDomain::quadrilateral:
    return std::span<const int>(over_quadrilateral).first(nodes);
  default:
    return {};
  }
}

} // namespace spricka::mesh
