// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>
#include <string_view>
#include <vector>

/// Words of damage tolerance that are no words of the language, and where they lead.
namespace spricka::grammar {

struct DamageToleranceTerm {
  std::string_view word;
  std::string_view also = {}; ///< other words for it, with commas between
  std::string_view text;      ///< what it is called here, or that there is no such thing
  std::string_view topics;    ///< cards, keys and results that `spricka help` explains further
  std::string_view pages;     ///< of the manual, without .md
};

/// All of them, in the order of the alphabet.
std::span<const DamageToleranceTerm> damage_tolerance_terms();

/// The word itself and the others that mean it.
std::vector<std::string_view> term_synonyms(const DamageToleranceTerm& word);

/// The entry of a word in any case, singular or plural, with blanks or - between its parts; null
/// when there is none.
const DamageToleranceTerm* find_damage_tolerance_term(std::string_view name);

} // namespace spricka::grammar
