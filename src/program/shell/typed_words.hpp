// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>
#include <vector>

/// What a user types, by the rules of the deck language.
namespace spricka::program {

/// Words are parted by blanks outside of brackets and quotes, which are taken off. ! begins a
/// comment.
std::vector<std::string> split_shell_words(std::string_view line);

/// The text of a line up to a comment, without blanks at its ends.
std::string_view strip_comment(std::string_view line);

/// What a line is meant for by its form.
enum class ShellLineForm {
  nothing,   ///< a comment
  card,      ///< $CARD KEY=value
  result,    ///< NAME(arguments)
  parameter, ///< NAME = expression
  command
};
/// The form of a line, comment and blanks around it left out.
ShellLineForm classify_shell_line(std::string_view line);

} // namespace spricka::program
