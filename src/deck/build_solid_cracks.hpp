// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/context.hpp"
#include "model/cracks.hpp"

namespace spricka::deck {

/// Reads the keys and data lines of a crack in space into it: an ellipse with A, or a front drawn
/// by its points. Mistakes are reported.
void read_solid_crack(DeckContext& context, const CheckedCard& card, model::CrackDefinition& crack);

/// Reads the data lines of a crack, a point with `dim` coordinates in each, into it; `form` says
/// what a line is. False after an error.
bool read_crack_points(DeckContext& context, const CheckedCard& card, std::size_t dim,
                       std::string_view form, model::CrackDefinition& crack);

} // namespace spricka::deck
