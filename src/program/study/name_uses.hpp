// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/source.hpp"
#include "deck/deck_text.hpp"

#include <map>
#include <set>
#include <string>

/// Where the parameters of a deck are used.
namespace spricka::program {

struct ParameterUse {
  std::set<std::size_t> counts; ///< $MESH cards whose numbers of elements it goes into [card]
  bool elsewhere = false;       ///< any other use
};

/// By name in upper case; a parameter has the uses of those that are made of it.
std::map<std::string, ParameterUse> find_parameter_uses(const deck::DeckCardList& text,
                                                        const base::SourceTexts& sources);

/// Parameters that go into the value of one, by its name, directly or through others, and itself.
std::map<std::string, std::set<std::string>>
parameter_dependencies(const deck::DeckCardList& text, const base::SourceTexts& sources);

/// Whether a key of $MESH is a number of elements, or how their sizes are spread.
bool is_element_count_key(std::string_view key);

} // namespace spricka::program
