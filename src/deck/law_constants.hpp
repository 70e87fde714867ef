// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/context.hpp"
#include "model/crack_growth.hpp"

namespace spricka::deck {

/// The constants of a growth law, which $GROW gives in KUNIT and AUNIT, and its rows; its law is
/// known. Mistakes are added to the context's.
void read_law_constants(DeckContext& context, const CheckedCard& card,
                        model::CrackGrowthSettings& growth);

} // namespace spricka::deck
