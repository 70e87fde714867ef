// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/context.hpp"
#include "model/forward.hpp"
#include "model/twist_spectrum.hpp"

#include <optional>

namespace spricka::deck {

/// Levels and seed of $SPECTRUM TYPE=TWIST. Empty after an error, which is reported.
std::optional<model::TwistSettings> read_twist_settings(DeckContext& context,
                                                        const CheckedCard& card);

/// The unit of life of a spectrum as UNIT says, else that of which FLIGHTS, `counted_flights` (0:
/// none were counted) or HOURS has the number. Mistakes are reported.
void set_life_unit(DeckContext& context, const CheckedCard& card, double counted_flights,
                   model::SpectrumDefinition& spectrum);

} // namespace spricka::deck
