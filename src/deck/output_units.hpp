// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/units.hpp"
#include "deck/context.hpp"

namespace spricka::deck {

/// What $DECK chooses to write results in, of a card whose keys are checked, in a deck of these
/// units.
base::OutputUnitChoice read_output_units(DeckContext& context, const CheckedCard& deck,
                                         const base::UnitSystem& units);

/// Whether lives can be written in what OUTLIFE names; an error where they cannot.
void check_output_life(DeckContext& context);

} // namespace spricka::deck
