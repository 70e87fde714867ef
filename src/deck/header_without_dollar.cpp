// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/header_without_dollar.hpp"

#include "grammar/lexeme.hpp"
#include "grammar/slips.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

using grammar::CardField;

bool is_header(const grammar::DataRow& row) {
  const std::vector<CardField>& f = row.fields;
  return f.size() > 2 && f[0].is_name() && f[0].separator == ' ' && f[1].is_name() &&
         f[1].separator == '=' && grammar::find_card(f[0].text) != nullptr;
}

} // namespace

std::string card_name_hint(std::string_view word) {
  const std::string upper = grammar::to_upper(word);
  return grammar::find_card(upper) != nullptr
             ? fmt::format("did you mean ${}?", upper)
             : std::string(grammar::foreign_syntax_hint(word.data(), word.data(),
                                                        word.data() + word.size()));
}

void drop_header_without_dollar(DeckContext& context, CheckedCard& card) {
  const auto missing = std::ranges::find_if(card.rows, is_header);
  if (missing == card.rows.end()) {
    return;
  }
  const CardField& name = missing->fields.front();
  context.error(name.span, "E115",
                fmt::format("a card starts with $; this reads as data of ${}", card.spec->name),
                card_name_hint(name.text));
  for (const CardField& field : missing->fields) {
    if (!field.text.empty()) {
      context.names.poison_name_ending(field.text);
    }
  }
  card.rows.erase(missing, card.rows.end());
  card.rows_bad = true;
}

} // namespace spricka::deck
