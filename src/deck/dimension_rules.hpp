// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/by_dimension.hpp"
#include "base/quantity.hpp"

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace spricka::deck {

/// What a deck may ask for, and what is said to it, by the dimension of its elements.
struct DimensionRules {
  std::string_view where;
  base::QuantityKind side_measure; ///< of the sides of elements
  bool ends_in_fronts;             ///< cracks end in fronts, not in tips

  std::string_view corner_order; ///< of elements that are not turned inside out
  std::string_view mesh_size;    ///< a key that $MESH needs; empty: none
  std::string_view rigid_targets;

  /// Of $TIPNET, where RINGS and SECTORS are left out; empty: as the grammar has it. Of a tube more
  /// rings change K by 1e-4, more sectors by 1e-3 at the cost of as many more elements.
  std::optional<int> tip_rings, tip_sectors;
  /// Of a life: K of fronts scatters from mesh to mesh by some thousandths, and a life is no better
  /// than that.
  double life_stop;

  std::string_view contacts;                      ///< which they are
  std::span<const std::string_view> contact_only; ///< results that contacts here alone have
  std::string_view contact_results;               ///< that there are, told to who asks for others
  std::string_view crack_results;                 ///< of a crack, by the name of a result
  std::string_view mode_one;                      ///< the result meant by K
};

inline constexpr std::array<std::string_view, 9> plane_contact_results{
    "ARC.FROM",   "ARC.TO",   "ARC.PARTS", "ARC.PART.FROM", "ARC.PART.TO",
    "STICK.FROM", "STICK.TO", "CPRESS.AT", "SHEAR.AT"};
inline constexpr std::array<std::string_view, 3> solid_contact_results{"CONTACT.AREA", "STICK.AREA",
                                                                       "MOMENT"};

inline constexpr base::ByDimension<DimensionRules> dimension_rules{
    {.where = "the plane",
     .side_measure = base::QuantityKind::length,
     .ends_in_fronts = false,
     .corner_order = "corners run counter-clockwise",
     .mesh_size = {},
     .rigid_targets = "in the plane and about an axis a target is a LINE or an ARC",
     .tip_rings = {},
     .tip_sectors = {},
     .life_stop = 1e-3,
     .contacts = "in the plane",
     .contact_only = plane_contact_results,
     .contact_results = "in the plane there are CPRESS.AT, ARC.FROM, ARC.TO and SUM",
     .crack_results = "in the plane there is {}(crack, step)",
     .mode_one = "K"},
    {.where = "space",
     .side_measure = base::QuantityKind::area,
     .ends_in_fronts = true,
     .corner_order = "corners of the first side run clockwise, seen from outside",
     .mesh_size = "LZ",
     .rigid_targets = "solids meet a PLANE, CYLINDER, CONE or SPHERE",
     .tip_rings = 3,
     .tip_sectors = 8,
     .life_stop = 0.02,
     .contacts = "between solids",
     .contact_only = solid_contact_results,
     .contact_results = "between solids there are CPRESS.NEAR, CONTACT.AREA, SUM and MOMENT",
     .crack_results = "along a front there are {0}.AT(crack, x, y, z, step), "
                      "{0}.PHI(crack, step, angle), {0}.MIN and {0}.MAX",
     .mode_one = "K1"}};

/// What models of the other dimension have.
constexpr const DimensionRules& other_dimension_rules(int dim) {
  return dimension_rules.at(5 - dim);
}

} // namespace spricka::deck
