// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/element_type.hpp"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace spricka::mesh {

/// An element entry of bulk data in our terms: with its corners alone, or with all middles of
/// edges.
struct NastranElementEntry {
  std::string_view name;
  base::ElementType linear, quadratic;
  std::size_t corners;
  std::size_t nodes;       ///< fields for nodes; equal to `corners` where there are no middles
  std::size_t thicknesses; ///< fields for those at corners, from the eleventh on
  bool special;            ///< with its corners alone it is no plain isoparametric element there
};

/// Null for entries that are no solid, shell or membrane of the element library.
const NastranElementEntry* find_nastran_element(std::string_view name);

/// Nastran's places of our nodes for a quadratic element; empty where both agree. Source: MSC and
/// NX Nastran Quick Reference Guide, CHEXA and CPENTA.
std::span<const int> nastran_node_order(base::ElementType type);

/// Places of the nodes of an element turned over (plane) or mirrored (solid): right-handed becomes
/// left-handed, and the other way round.
std::vector<int> mirrored_node_order(base::ElementType type);

} // namespace spricka::mesh
