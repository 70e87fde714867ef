// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/mortar_sums.hpp"

#include <cstddef>
#include <vector>

/// From integration points to constraint rows.
namespace spricka::contact {

/// Fills the rows of a SEGMENT pair whose two surfaces stand in `pair` from what the elements of
/// the contact surface meet (make_target_projector()). The pressure is a sum of hats on these
/// elements. In the plane gaps and motions are weighted by the hats themselves; in space
/// (contact_space.5) by the functions dual to them (Wohlmuth 2000) on what the target covers of
/// each triangle (Popp et al. 2013), so that each weight is positive on any face type and any part
/// of a face. A function covered by less than a fifth joins a neighbour. Where surfaces face each
/// other twice, or normals miss what they face, `trouble` says so and there are no rows.
void fill_mortar_rows(PairConstraints& pair, const ElementProjector& project,
                      const MortarRowOptions& options);

/// Integrates anew the rows of a SEGMENT pair to which some elements of the contact surface add
/// [element], where nodes of the two surfaces have been moved a little since. Which functions have
/// rows, and whose they joined, stays as it is. False, and nothing is changed: other functions
/// would get rows, or `trouble` would say why there are none.
bool renew_mortar_rows(PairConstraints& pair, const ElementProjector& project,
                       const MortarRowOptions& options, const std::vector<bool>& changed);

/// Places among the pair's functions of the nodes of each facet of its contact surface, or of its
/// corners where only these have functions.
std::vector<std::vector<std::size_t>> functions_by_facet(const PairConstraints& pair);

/// The normal row of each of these functions, which may be that of another it joined,
/// [facet][node]; -1: none.
std::vector<std::vector<int>> normal_rows_by_facet(const PairConstraints& pair);

} // namespace spricka::contact
