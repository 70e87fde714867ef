// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"
#include "contact/space/pair_point.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

/// From integration points to constraint rows.
namespace spricka::contact {

/// [node of a crack's front] the node behind it.
using NodesBehindFront = std::map<base::NodeId, base::NodeId>;

/// What the rows of a SEGMENT pair are made with.
struct MortarRowOptions {
  std::optional<double> declared_gap; ///< in the place of the measured ones [length]
  bool tangents = false;              ///< rows along the surface for each normal one
  /// Functions of nodes at a crack's front, where the faces cannot part, go to the nodes behind it.
  NodesBehindFront at_front = {};
};

/// Fills the rows of a SEGMENT pair whose two surfaces stand in `pair` from what the elements of
/// the contact surface meet (make_target_projector()). The pressure is a sum of hats on these
/// elements. In the plane gaps and motions are weighted by the hats themselves; in space
/// (contact_space.5) by the functions dual to them (Wohlmuth 2000) on what the target covers of
/// each triangle (Popp et al. 2013), so that each weight is positive on any face type and any part
/// of a face. A function covered by less than a fifth joins a neighbour. Where surfaces face each
/// other twice, or normals miss what they face, `trouble` says so and there are no rows.
void fill_mortar_rows(PairConstraints& pair, const ElementProjector& project,
                      const MortarRowOptions& options);

/// Places among the pair's functions of the nodes of each facet of its contact surface, or of its
/// corners where only these have functions.
std::vector<std::vector<std::size_t>> functions_by_facet(const PairConstraints& pair);

/// The normal row of each of these functions, which may be that of another it joined,
/// [facet][node]; -1: none.
std::vector<std::vector<int>> normal_rows_by_facet(const PairConstraints& pair);

} // namespace spricka::contact
