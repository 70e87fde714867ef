// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "grammar/catalogue.hpp"
#include "model/forward.hpp"

#include <string>
#include <string_view>
#include <vector>

/// What a user types, read by the rules of the deck language.
namespace spricka::program {

/// A word and where it stands in the line.
struct ShellWord {
  std::string text; ///< without quotes
  std::size_t begin = 0;
  bool quoted = false;
};

/// Words are parted by blanks outside of brackets and quotes; = is a word of its own. ! begins a
/// comment.
std::vector<ShellWord> shell_words(std::string_view line);

/// The text of a line up to a comment, without blanks at its ends.
std::string_view without_comment(std::string_view line);

/// A number: an expression of the deck language with the deck's parameters, units of this quantity.
base::Trouble read_number(const std::string& text, const model::Model& model,
                          grammar::Quantity quantity, double& value);

/// Whether a line asks for a quantity of $CHECK: NAME(arguments).
bool asks_quantity(std::string_view line);

/// A quantity of $CHECK with its arguments; every name is one of the deck, a step may be NOW.
base::Trouble read_quantity(const std::string& text, const model::Model& model,
                            model::ResultCheck& check);

/// Names that an argument of this letter (grammar/catalogue.hpp) can be; empty for numbers.
std::vector<std::string> argument_names(char letter, const model::Model& model);

} // namespace spricka::program
