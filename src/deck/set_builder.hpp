// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/context.hpp"
#include "deck/set_finder.hpp"

#include <vector>

namespace spricka::deck {

/// Builds the set of an $NSET, $ESET or $FSET card into the mesh and notes its index under its
/// name; after an error the name is poisoned. The sets that the card names come by `sets`.
void build_set(DeckContext& context, const CheckedCard& card, const SetFinder& sets);

/// Boundary faces all of whose nodes are listed. The boundary of the mesh is found only once.
std::vector<model::Face> cached_boundary_faces_within(DeckContext& context,
                                                      const std::vector<base::NodeId>& nodes);

} // namespace spricka::deck
