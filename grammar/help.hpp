// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "grammar/catalogue.hpp"

#include <string>
#include <string_view>

/// What `spricka help` prints, made of the catalogue and the words of the field, in lines of at
/// most `width` columns (but for examples and words that are longer).
namespace spricka::grammar {

/// All cards by group, one line each.
std::string card_list_help(std::size_t width);

/// One card: keys, rules between them, data lines, notes, example.
std::string card_help(const CardSpec& card, std::size_t width);

/// Where a word of the language stands, given in capitals: as a key, as a value of one, as a
/// function. Empty when it is none.
std::string language_word_help(std::string_view word, std::size_t width);

/// Where the texts of cards, keys and results have a word, given in any case. Empty: nowhere.
std::string search_help_texts(std::string_view word, std::size_t width);

/// Where a word of damage tolerance leads, given in any case. Empty: it is not known.
std::string damage_tolerance_help(std::string_view word, std::size_t width);

/// All words of damage tolerance that lead somewhere, with others for each.
std::string list_damage_tolerance_terms(std::size_t width);

/// The results that $CHECK can name; `one` alone if it is given.
std::string result_quantities_help(std::size_t width, const ResultQuantity* one = nullptr);

/// Functions, constants and variables of expressions.
std::string functions_help(std::size_t width);

/// Units and how they are combined.
std::string units_help(std::size_t width);

/// The card reference of the manual: all of the above as Markdown.
std::string card_reference_markdown();

/// The whole catalogue as JSON, for editors and other programs.
std::string card_catalogue_json();

} // namespace spricka::grammar
