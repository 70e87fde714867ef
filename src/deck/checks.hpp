// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/context.hpp"

namespace spricka::deck {

/// The lines of a $CHECK card into the model: quantities and their arguments against the
/// catalogue, names against the deck.
void read_checks(DeckContext& context, const CheckedCard& card);

/// A line that names a result with its arguments and no more, by the same rules, as one of this
/// $CHECK card. Empty after an error, which is reported.
std::optional<model::ResultCheck> read_result_request(DeckContext& context, const CheckedCard& card,
                                                      const grammar::DataRow& row);

} // namespace spricka::deck
