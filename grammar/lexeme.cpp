// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/lexeme.hpp"

#include <charconv>
#include <cstring>
#include <system_error>

namespace spricka::grammar {

const char* line_end(const char* p, const char* last) {
  if (p >= last) {
    return last;
  }
  const void* found = std::memchr(p, '\n', static_cast<std::size_t>(last - p));
  return found == nullptr ? last : static_cast<const char*>(found);
}

const char* find_continuation_line(const char* p, const char* last) {
  while (p < last && *p == '\n') {
    ++p;
    while (p < last && is_blank(*p)) {
      ++p;
    }
    if (p < last && *p == '&') {
      return p + 1;
    }
    if (p >= last || *p != '!') {
      return nullptr;
    }
    p = line_end(p, last);
  }
  return nullptr;
}

const char* skip_blanks_and_comments(const char* p, const char* last) {
  while (p < last) {
    const bool return_at_end = *p == '\r' && (p + 1 == last || p[1] == '\n');
    if (is_blank(*p) || return_at_end) {
      ++p;
    } else if (*p == '!') {
      p = line_end(p, last);
    } else if (*p == '\n') {
      const char* more = find_continuation_line(p, last);
      if (more == nullptr) {
        return p;
      }
      p = more;
    } else {
      return p;
    }
  }
  return last;
}

const char* logical_line_end(const char* p, const char* last) {
  while (true) {
    const char* end = line_end(p, last);
    const char* more = find_continuation_line(end, last);
    if (more == nullptr) {
      return end;
    }
    p = more;
  }
}

const char* scan_name(const char* p, const char* last) {
  if (p >= last || !is_letter(*p)) {
    return p;
  }
  while (p < last && is_name_char(*p)) {
    ++p;
  }
  return p;
}

const char* scan_qualified_name(const char* p, const char* last) {
  const char* end = scan_name(p, last);
  if (end == p) {
    return p;
  }
  while (last - end > 1 && *end == '.' && is_name_char(end[1])) {
    ++end;
    while (end < last && is_name_char(*end)) {
      ++end;
    }
  }
  return end;
}

ScannedNumber scan_number(const char* p, const char* last) {
  ScannedNumber number;
  number.end = p;
  // from_chars would also take inf and nan, which are names here.
  const bool starts = p < last && (is_digit(*p) || (*p == '.' && last - p > 1 && is_digit(p[1])));
  if (!starts) {
    number.error = NumberError::absent;
    return number;
  }
  const auto [end, failure] = std::from_chars(p, last, number.value);
  number.end = end;
  if (failure == std::errc::result_out_of_range) {
    number.error = NumberError::too_large;
  }
  if (end < last && (is_name_char(*end) || *end == '.')) {
    const bool fortran = *end == 'd' || *end == 'D' || *end == 'q' || *end == 'Q';
    const char* stop = end;
    while (stop < last && (is_name_char(*stop) || *stop == '.' ||
                           ((*stop == '+' || *stop == '-') && !is_digit(stop[-1])))) {
      ++stop;
    }
    number.end = stop;
    const bool digits_follow = fortran && stop - end > 1 && is_digit(stop[-1]);
    number.error = digits_follow ? NumberError::fortran_exponent : NumberError::trailing;
  }
  return number;
}

const char* scan_token(const char* p, const char* last) {
  if (p >= last || is_line_end_or_comment(*p)) {
    return p;
  }
  if (*p == '\'') {
    const char* q = p + 1;
    while (q < last && *q != '\'' && *q != '\n') {
      ++q;
    }
    return q < last && *q == '\'' ? q + 1 : q;
  }
  const auto separates = [](char c) {
    return is_blank(c) || is_line_end_or_comment(c) || c == ',' || c == '=' || c == '(' ||
           c == ')' || c == '\'' || c == ':';
  };
  const char* q = p + 1;
  if (!separates(*p)) {
    while (q < last && !separates(*q)) {
      ++q;
    }
  }
  return q;
}

std::string to_upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'a' && c <= 'z') {
      c = static_cast<char>(c - 'a' + 'A');
    }
  }
  return result;
}

} // namespace spricka::grammar
