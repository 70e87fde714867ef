// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "grammar/card_spec.hpp"

#include <span>
#include <string_view>

/// The catalogue: every card of the language with its keys, in one table. It drives binding and
/// checking, the help, the card reference of the manual and the schema for editors. A new card is
/// one entry here and one function in the deck room.
namespace spricka::grammar {

/// All cards, in the order of the manual.
std::span<const CardSpec> card_catalogue();

/// A card by its upper-case name without $; null when unknown.
const CardSpec* find_card(std::string_view name);

/// Whether a key of $GROW and $LAW is a constant of a growth law, or says how one counts.
bool is_law_constant(std::string_view key);

/// A result that $CHECK and the prompt can name, and what its arguments are: letters of
/// find_argument_by_letter, and a for a number, z for one that solids need; a letter after ? may be
/// left out.
struct ResultQuantity {
  std::string_view name = {};
  std::string_view arguments;
  QuantityKind quantity = QuantityKind::number;
  std::string_view doc = {};
};
/// What a letter of ResultQuantity::arguments stands for.
struct ResultArgument {
  char letter = ' ';
  EntityKind kind = EntityKind::none; ///< of a name; none: a direction
  std::string_view form = {};         ///< as the help writes it: "crack[.tip]"
};
/// The argument of a letter; null for numbers.
const ResultArgument* find_argument_by_letter(char letter);

/// All quantities, those of fronts in space behind the last one of tips.
std::span<const ResultQuantity> result_quantities();
/// The quantity of that name, upper case; null: there is none.
const ResultQuantity* find_result_quantity(std::string_view name);

} // namespace spricka::grammar
