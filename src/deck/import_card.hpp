// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/context.hpp"

namespace spricka::deck {

/// Reads the file of an $IMPORT card into the mesh; its sets and numbers are still to be made
/// known. Materials and properties of the file wait in the context.
void import_mesh_file(DeckContext& context, const CheckedCard& card);

} // namespace spricka::deck
