// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

namespace spricka::base {

/// The element library, by ASKA's names. M = membrane, C = curved (isoparametric), the number =
/// nodes. Corners first, then mid-edge nodes, then face and volume nodes, as Abaqus and CalculiX;
/// gmsh orders some solids otherwise (mesh/gmsh_elements.cpp), and so does VTK
/// (report/drawing/vtu_grid.cpp).
enum class ElementType : std::uint8_t {
  trim3,
  trimc6,
  quam4,
  quamc8,
  quamc9,
  tet4,
  tet10,
  penta6,
  pentac15,
  hexe8,
  hexec20,
  hexec27
};

/// The body that the reference coordinates of an element or of a side run over.
enum class ReferenceDomain : std::uint8_t {
  line,
  triangle,
  quadrilateral,
  tetrahedron,
  prism,
  hexahedron
};

struct ElementInfo {
  std::string_view name; ///< the deck's word
  int nodes;
  int corners;
  int dim; ///< of the element's own space
  int sides;
  bool quadratic;
  ReferenceDomain domain;
};

inline constexpr std::array<ElementInfo, 12> element_infos{{
    {"TRIM3", 3, 3, 2, 3, false, ReferenceDomain::triangle},
    {"TRIMC6", 6, 3, 2, 3, true, ReferenceDomain::triangle},
    {"QUAM4", 4, 4, 2, 4, false, ReferenceDomain::quadrilateral},
    {"QUAMC8", 8, 4, 2, 4, true, ReferenceDomain::quadrilateral},
    {"QUAMC9", 9, 4, 2, 4, true, ReferenceDomain::quadrilateral},
    {"TET4", 4, 4, 3, 4, false, ReferenceDomain::tetrahedron},
    {"TET10", 10, 4, 3, 4, true, ReferenceDomain::tetrahedron},
    {"PENTA6", 6, 6, 3, 5, false, ReferenceDomain::prism},
    {"PENTAC15", 15, 6, 3, 5, true, ReferenceDomain::prism},
    {"HEXE8", 8, 8, 3, 6, false, ReferenceDomain::hexahedron},
    {"HEXEC20", 20, 8, 3, 6, true, ReferenceDomain::hexahedron},
    {"HEXEC27", 27, 8, 3, 6, true, ReferenceDomain::hexahedron},
}};

/// Name, numbers of nodes, corners and sides, dimension and order of an element type.
constexpr const ElementInfo& element_info(ElementType type) {
  return element_infos[static_cast<std::size_t>(type)];
}

/// The type of a name, which must be one of the library.
constexpr ElementType element_type_by_name(std::string_view name) {
  std::size_t type = 0;
  while (element_infos[type].name != name) {
    ++type;
  }
  return static_cast<ElementType>(type);
}

} // namespace spricka::base
