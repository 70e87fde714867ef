// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>

namespace spricka::base {

/// Valid UTF-8 without control characters but tabs, so that a terminal or a log can show any text
/// or name of a file: what is neither becomes a question mark, bytes that continue nothing are left
/// out, columns stay.
std::string make_printable(std::string_view text);

/// The same of every line of a text, the ends of the lines kept.
std::string make_lines_printable(std::string_view text);

/// Whether a byte continues a UTF-8 character that began before it.
bool is_utf8_continuation_byte(char c);

} // namespace spricka::base
