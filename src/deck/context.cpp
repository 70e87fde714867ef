// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/context.hpp"

#include <algorithm>

namespace spricka::deck {

const CheckedCard* DeckContext::first_card(std::string_view name) const {
  const auto found =
      std::ranges::find_if(cards, [&](const CheckedCard& card) { return card.spec->name == name; });
  return found == cards.end() ? nullptr : &*found;
}

} // namespace spricka::deck
