// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/context.hpp"

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

/// The lines of numbers in the file that a key of a card names, beside the deck: separated by
/// blanks, commas or semicolons, what follows ! or # is a comment; lines without numbers are left
/// out. A file that cannot be read is said (E308) and gives nothing.
std::optional<std::vector<NumberLine>>
read_number_file(DeckContext& context, const CheckedCard& card, std::string_view key);

} // namespace spricka::deck
