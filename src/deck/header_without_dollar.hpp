// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/context.hpp"

namespace spricka::deck {

/// A data line like `STEP NAME=PULL` is a header whose $ was forgotten: it is reported, what it
/// would have defined is poisoned, and it and the lines below it leave the card.
void drop_header_without_dollar(DeckContext& context, CheckedCard& card);

/// "did you mean $STEP?" when a word is the name of a card, what to write in place of a foreign
/// sign, else empty.
std::string card_name_hint(std::string_view word);

} // namespace spricka::deck
