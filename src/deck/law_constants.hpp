// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/context.hpp"
#include "model/crack_growth.hpp"

#include <string_view>

namespace spricka::deck {

/// The law that a card says, $GROW or $LAW, whose `key` LAW or TYPE names it: constants in KUNIT
/// and AUNIT, rows of a table, what is known of its tests. The toughness of a thickness is left to
/// toughness_of_thickness(). Mistakes are added to the context's.
model::GrowthLawDefinition read_growth_law(DeckContext& context, const CheckedCard& card,
                                           std::string_view key);

/// K_c [stress intensity] of a thickness [length] (life.27).
double toughness_of_thickness(const model::ToughnessOverThickness& toughness, double thickness);

} // namespace spricka::deck
