// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/context.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace spricka::deck {

/// Numbers of one line of a file, or of a card, and the place for messages about it.
struct NumberLine {
  std::vector<double> numbers;
  base::SourceSpan span;
  std::string where; ///< "line 17 of 'f.txt': "; empty: the span says it
  bool sound = true; ///< nothing but numbers stood there
};

/// How a file of numbers is laid out. Numbers are separated by blanks, commas or semicolons.
struct NumberFileLayout {
  std::size_t skipped_lines = 0; ///< at its beginning
  std::string comment;           ///< what follows it is left out; empty: ! and #
  std::string mark;              ///< a line that begins with this word is a mark; empty: none
};

/// A line of a file that has numbers or is a mark.
struct NumberRow {
  std::span<const double> numbers; ///< while it is looked at
  std::size_t line = 0;            ///< from 1
  bool sound = true;               ///< nothing but numbers stood there
  bool mark = false;
};

/// "line 17 of 'f.txt': "
std::string describe_file_line(std::string_view file, std::size_t line);

/// Shows the lines of numbers in the file that a key of a card names, beside the deck, to `take`
/// one after another, until it says false; lines without numbers are left out. Returns the file's
/// name; a file that cannot be read is said (E308), and the name is empty.
std::string visit_number_file(DeckContext& context, const CheckedCard& card, std::string_view key,
                              const NumberFileLayout& layout,
                              const std::function<bool(const NumberRow&)>& take);

/// The lines of numbers of such a file, up to the first one that is not sound. A file that cannot
/// be read gives nothing.
std::optional<std::vector<NumberLine>>
read_number_file(DeckContext& context, const CheckedCard& card, std::string_view key);

} // namespace spricka::deck
