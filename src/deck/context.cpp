// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/context.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace spricka::deck {

const CheckedCard* DeckContext::find_first_card(std::string_view name) const {
  const auto found =
      std::ranges::find_if(cards, [&](const CheckedCard& card) { return card.spec->name == name; });
  return found == cards.end() ? nullptr : &*found;
}

void DeckContext::report_duplicate_name(const NameDefinition& second, std::string_view name,
                                        const NameDefinition& first) {
  error(second.span, "E302",
        fmt::format("{} {} is defined twice", grammar::display_name(second.kind), name),
        fmt::format("first in line {}", line_number(first.span)));
}

bool DeckContext::has_bad_card(std::string_view name) const {
  return std::ranges::any_of(
      cards, [&](const CheckedCard& card) { return card.spec->name == name && card.bad; });
}

double DeckContext::key_unit_factor(const CheckedCard& card, std::string_view key) const {
  const auto unit = base::parse_unit(card.word_value(key));
  return card.has_key(key) && unit ? base::factor_to_deck_units(*unit, scope.units) : 1.0;
}

const CheckedCard* DeckContext::find_sound_card_named(std::string_view card,
                                                      std::string_view name) const {
  const auto found = std::ranges::find_if(cards, [&](const CheckedCard& one) {
    return one.spec->name == card && !one.bad && one.word_value("NAME") == name;
  });
  return found == cards.end() ? nullptr : &*found;
}

base::NetId DeckContext::find_net(std::string_view name) const {
  const auto found = std::ranges::find(model.nets, name, &model::NetDefinition::name);
  return base::NetId(static_cast<std::size_t>(found - model.nets.begin()));
}

} // namespace spricka::deck
