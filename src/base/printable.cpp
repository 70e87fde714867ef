// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/printable.hpp"

#include <algorithm>

namespace spricka::base {

bool is_utf8_continuation_byte(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

namespace {

// Length of the UTF-8 character at `i`, 0 if there is none that is well formed.
std::size_t character_at(std::string_view text, std::size_t i) {
  const auto lead = static_cast<unsigned char>(text[i]);
  const std::size_t length = lead < 0x80U   ? 1
                             : lead < 0xC2U ? 0
                             : lead < 0xE0U ? 2
                             : lead < 0xF0U ? 3
                             : lead < 0xF5U ? 4
                                            : 0;
  for (std::size_t k = 1; k < length; ++k) {
    if (i + k >= text.size() || !is_utf8_continuation_byte(text[i + k])) {
      return 0;
    }
  }
  return length;
}

bool is_control(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  // U+0080 to U+009F steer some terminals as escape sequences do.
  return character.size() == 1 ? first < 0x20U || first == 0x7FU
                               : first == 0xC2U && static_cast<unsigned char>(character[1]) < 0xA0U;
}

} // namespace

std::string make_printable(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_at(text, i);
    if (length > 0 && (text[i] == '\t' || !is_control(text.substr(i, length)))) {
      out += text.substr(i, length);
    } else if (!is_utf8_continuation_byte(text[i])) {
      out += '?';
    }
    i += std::max<std::size_t>(length, 1);
  }
  return out;
}

std::string make_lines_printable(std::string_view text) {
  std::string out;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    out += make_printable(text.substr(begin, end - begin));
    out += end < text.size() ? "\n" : "";
    begin = end + 1;
  }
  return out;
}

} // namespace spricka::base
