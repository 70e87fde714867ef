// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "model/forward.hpp"

#include <string>
#include <string_view>
#include <vector>

/// The names that words of the shell can stand for.
namespace spricka::program {

/// Names that an argument of this letter (grammar/catalogue.hpp) can be: for p those of contacts
/// and of crack faces that may touch, for s NOW and the deck's steps; v are the parameters as the
/// deck writes them. Empty for numbers.
std::vector<std::string> candidate_argument_names(char letter, const model::Model& model);

/// Whether a tip or front belongs to the crack of that name, or is that tip; to any if it is empty.
bool is_tip_of_crack(const std::string& tip, const std::string& crack);

/// The place of a name (upper case) in a list, or what it is not and which was meant.
base::OptionalFailure find_name_index(const std::vector<std::string>& names, const char* what,
                                      const std::string& name, std::size_t& index);

/// The same word but for the case of its letters.
bool same_word(std::string_view a, std::string_view b);

} // namespace spricka::program
