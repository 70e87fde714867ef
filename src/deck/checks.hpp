// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/context.hpp"

namespace spricka::deck {

/// The lines of a $CHECK card into the model: quantities and their arguments against the
/// catalogue, names against the deck.
void read_checks(DeckContext& context, const CheckedCard& card);

} // namespace spricka::deck
