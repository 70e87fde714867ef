// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/context.hpp"

namespace spricka::deck {

/// Whether the mesh that a $MESH card asks for has a size that can be handled and its numbers fit
/// behind those of its net; a slip of the finger must not fill the memory. False after an error.
bool check_requested_mesh_size(DeckContext& context, const CheckedCard& card);

} // namespace spricka::deck
