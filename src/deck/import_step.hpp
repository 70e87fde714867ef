// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/context.hpp"
#include "mesh/import/import_request.hpp"

namespace spricka::deck {

/// Reads the STEP file of an $IMPORT card, names its faces by the data lines, and meshes the solids
/// of SOLID into the open net. `request` has file, net, span and SCALE.
void import_step_file(DeckContext& context, const CheckedCard& card, mesh::ImportRequest request);

} // namespace spricka::deck
