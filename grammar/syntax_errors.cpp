// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/syntax_errors.hpp"

#include "grammar/slips.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace spricka::grammar {

namespace {

// The usual slips, by what stands where something else was expected.
std::string hint_for(char found, std::string_view wanted) {
  const bool closing = wanted.starts_with("')'");
  switch (found) {
  case '[':
    return "a unit follows its number without a blank, 210[GPa]";
  case '"':
    return "a text stands in single quotes";
  case '&':
    return "& comes first on the line that continues";
  case '*':
    return wanted.starts_with("a number, a name, a text") ? "a card starts with $" : "";
  case '=':
    return closing ? "equality is written ==" : "";
  case '<':
  case '>':
    return closing ? "join two comparisons with and" : "";
  case ',':
    return closing ? "a comma separates arguments; no blank before their bracket" : "";
  default:
    break;
  }
  return wanted == "'='" ? "write KEY=value" : "";
}

} // namespace

base::SourceSpan FirstSyntaxError::span(const char* begin, const char* end) const {
  return {file_, static_cast<std::uint32_t>(begin - origin_),
          static_cast<std::uint32_t>(end - origin_)};
}

bool FirstSyntaxError::record_error(base::SourceSpan place, std::string code, std::string text,
                                    std::string hint) {
  if (!failure_) {
    failure_ = SyntaxErrorRecord{place, std::move(code), std::move(text), std::move(hint)};
  }
  return false;
}

void FirstSyntaxError::record_expected(const char* at, const char* last, std::string_view what) {
  const char* const before = at;
  at = skip_blanks_and_comments(at, last);
  if (at >= last || *at == '\n') {
    const char* comment = std::find(before, at, '!');
    const bool not_equal = comment + 1 < at && comment[1] == '=';
    at = comment; // the carets stand right after the last token
    while (at > origin_ && is_blank(at[-1])) {
      --at;
    }
    record_error(span(at, at), "E101", fmt::format("expected {}, the line ends early", what),
                 not_equal ? "! starts a comment" : "");
    return;
  }
  const char* end = scan_token(at, last);
  if (end == at) {
    ++end;
  }
  const std::string slip(foreign_syntax_hint(origin_, at, last));
  record_error(span(at, end), "E101",
               fmt::format("expected {}, not '{}'", what, std::string_view(at, end)),
               slip.empty() ? hint_for(*at, what) : slip);
}

void FirstSyntaxError::report(base::Diagnostics& diagnostics) const {
  if (failure_) {
    diagnostics.error(failure_->span, failure_->code, failure_->text, failure_->hint);
  }
}

bool FirstSyntaxError::record_bad_number(const char* begin, const char* end, const char* last,
                                         NumberError error) {
  const std::string_view token(begin, end);
  switch (error) {
  case NumberError::fortran_exponent:
    return record_error(span(begin, end), "E103", fmt::format("'{}': a Fortran exponent", token),
                        "write 1.0e-3, not 1.0d-3 or 1.0-3");
  case NumberError::too_large:
    return record_error(span(begin, end), "E103",
                        fmt::format("'{}' lies outside the range of double precision", token));
  default:
    break;
  }
  const std::string slip(foreign_syntax_hint(origin_, end, last));
  return record_error(span(begin, end), "E103", fmt::format("'{}' is not a number", token),
                      !slip.empty()
                          ? slip
                          : "a number is digits with a point and an exponent; a name starts with "
                            "a letter");
}

bool FirstSyntaxError::check_field_end(const char* p, const char* last, const CardField& field) {
  if (p >= last || is_blank(*p) || is_line_end_or_comment(*p) || *p == ',' || *p == '=') {
    return true;
  }
  const char* end = scan_token(p, last);
  const std::string_view rest(p, end == p ? p + 1 : end);
  const bool arithmetic = std::string_view("*/+-^<>").find(*p) != std::string_view::npos;
  const bool fortran = (*p == '-' || *p == '+') && end - p > 1 && is_digit(p[1]) &&
                       field.kind == CardField::CardFieldKind::number;
  if (fortran) {
    const char* begin = origin_ + field.span.begin;
    return record_error(span(begin, end), "E103",
                        fmt::format("'{}': a Fortran exponent, or two numbers without a blank",
                                    std::string_view(begin, end)),
                        "write 1.5e-3, or 1.5 -3, or (1.5-3)");
  }
  const std::string slip(foreign_syntax_hint(origin_, p, last));
  return record_error(span(p, p + rest.size()), "E102", fmt::format("unexpected '{}'", rest),
                      arithmetic ? "an expression stands in parentheses" : slip);
}

} // namespace spricka::grammar
