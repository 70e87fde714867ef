// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>

/// The smallest pieces of the language, as plain functions on bytes. Bytes above 127 are ordinary
/// (in comments and texts) and belong to no class.
namespace spricka::grammar {

/// Whether a byte is one of 0 to 9.
constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
/// Whether a byte may begin a name: a letter of ASCII or the underscore.
constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
/// Whether a byte may stand within a name: letter, underscore or digit.
constexpr bool is_name_char(char c) {
  return is_letter(c) || is_digit(c);
}
/// Whether a byte is a blank or a tabulator; line feeds are none.
constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

/// Blanks, carriage return, comment: what may stand between the last field and the line feed.
constexpr bool is_line_end_or_comment(char c) {
  return c == '\n' || c == '\r' || c == '!';
}

/// End of a line: at its line feed, or `last`.
const char* line_end(const char* p, const char* last);

/// Start of the continued text if the lines after the line feed at `p` continue this one (first
/// character &, after any comment lines), else null.
const char* find_continuation_line(const char* p, const char* last);

/// Skips blanks, comments and continued line ends; stops at a token, a line feed or `last`.
const char* skip_blanks_and_comments(const char* p, const char* last);

/// End of the logical line (with its continuations) that holds `p`: at its line feed, or `last`.
const char* logical_line_end(const char* p, const char* last);

/// End of the name that starts at `p`, or `p`.
const char* scan_name(const char* p, const char* last);

/// End of a name and what follows it after points, NAME { "." ( NAME | digits ) }, at `p`, or `p`.
const char* scan_qualified_name(const char* p, const char* last);

enum class NumberError { none, absent, too_large, fortran_exponent, trailing };

struct ScannedNumber {
  double value = 0.0;
  const char* end = nullptr;
  NumberError error = NumberError::none;
};

/// An unsigned number, exactly rounded. Demands that neither a letter nor a second point follows
/// (`1.0d0`, `2x`, `1.2.3` are errors whose `end` is that of the whole token).
ScannedNumber scan_number(const char* p, const char* last);

/// End of whatever token stands at `p`, for carets: to the next blank, separator or bracket.
const char* scan_token(const char* p, const char* last);

/// ASCII letters in upper case; all other bytes as they are.
std::string to_upper(std::string_view text);

} // namespace spricka::grammar
