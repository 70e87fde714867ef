// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/builder.hpp"

#include "grammar/lexeme.hpp"
#include "grammar/slips.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include <fmt/format.h>

namespace spricka::grammar {

namespace {
constexpr int k_deepest = 100; ///< nested brackets; keeps the recursive rules off the stack's end

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

base::SourceSpan SyntaxBuilder::span(const char* begin, const char* end) const {
  return {file_, static_cast<std::uint32_t>(begin - origin_),
          static_cast<std::uint32_t>(end - origin_)};
}

bool SyntaxBuilder::fail(base::SourceSpan place, std::string code, std::string text,
                         std::string hint) {
  if (!failure) {
    failure = SyntaxFailure{place, std::move(code), std::move(text), std::move(hint)};
  }
  return false;
}

void SyntaxBuilder::fail_expected(const char* at, const char* last, std::string_view what) {
  const char* const before = at;
  at = skip_blanks_and_comments(at, last);
  if (at >= last || *at == '\n') {
    const char* comment = std::find(before, at, '!');
    const bool not_equal = comment + 1 < at && comment[1] == '=';
    at = comment; // the carets stand right after the last token
    while (at > origin_ && is_blank(at[-1])) {
      --at;
    }
    fail(span(at, at), "E101", fmt::format("expected {}, the line ends early", what),
         not_equal ? "! starts a comment" : "");
    return;
  }
  const char* end = scan_token(at, last);
  if (end == at) {
    ++end;
  }
  const std::string slip(foreign_character_hint(origin_, at, last));
  fail(span(at, end), "E101", fmt::format("expected {}, not '{}'", what, std::string_view(at, end)),
       slip.empty() ? hint_for(*at, what) : slip);
}

void SyntaxBuilder::report_failure(base::Diagnostics& diagnostics) const {
  if (failure) {
    diagnostics.error(failure->span, failure->code, failure->text, failure->hint);
  }
}

bool SyntaxBuilder::bad_number(const char* begin, const char* end, const char* last, int error) {
  const std::string_view token(begin, end);
  switch (static_cast<NumberError>(error)) {
  case NumberError::fortran_exponent:
    return fail(span(begin, end), "E103", fmt::format("'{}': a Fortran exponent", token),
                "write 1.0e-3, not 1.0d-3 or 1.0-3");
  case NumberError::too_large:
    return fail(span(begin, end), "E103",
                fmt::format("'{}' lies outside the range of double precision", token));
  default:
    break;
  }
  const std::string slip(foreign_character_hint(origin_, end, last));
  return fail(span(begin, end), "E103", fmt::format("'{}' is not a number", token),
              !slip.empty() ? slip
                            : "a number is digits with a point and an exponent; a name starts with "
                              "a letter");
}

bool SyntaxBuilder::read_unit(const char*& p, const char* last, base::SourceSpan& found) {
  if (p >= last || *p != '[') {
    return true;
  }
  const char* q = p + 1;
  while (q < last && *q != ']' && *q != '\n') {
    ++q;
  }
  if (q >= last || *q != ']') {
    return fail(span(p, q), "E101", "expected ']' after the unit, the line ends early");
  }
  found = span(p + 1, q);
  p = q + 1;
  return true;
}

bool SyntaxBuilder::read_number(const char*& p, const char* last) {
  const ScannedNumber n = scan_number(p, last);
  if (n.error == NumberError::absent) {
    return false;
  }
  if (n.error != NumberError::none) {
    return bad_number(p, n.end, last, static_cast<int>(n.error));
  }
  ExpressionTerm term;
  term.value = n.value;
  term.span = span(p, n.end);
  p = n.end;
  if (!read_unit(p, last, term.unit)) {
    return false;
  }
  token_end_ = p;
  terms_.push_back(term);
  return true;
}

bool SyntaxBuilder::read_trailing_unit(const char*& p, const char* last) {
  ExpressionTerm term;
  term.kind = ExpressionTerm::ExpressionTermKind::scale;
  if (!read_unit(p, last, term.unit)) {
    return false;
  }
  token_end_ = p;
  if (term.unit.valid()) {
    term.span = term.unit;
    terms_.push_back(term);
  }
  return true;
}

bool SyntaxBuilder::enter_nesting(const char* p, const char* last) {
  if (++depth_ > k_deepest) {
    return fail(p < last ? span(p, p + 1) : span(p - 1, p), "E102",
                "the expression is nested too deeply");
  }
  return true;
}

void SyntaxBuilder::push_name(const char* begin, const char* end) {
  ExpressionTerm term;
  term.kind = ExpressionTerm::ExpressionTermKind::name;
  term.span = span(begin, end);
  token_end_ = end;
  terms_.push_back(term);
}

bool SyntaxBuilder::begin_call() {
  ExpressionTerm term = terms_.back();
  terms_.pop_back();
  term.kind = ExpressionTerm::ExpressionTermKind::call;
  calls_.push_back(term);
  return true;
}

void SyntaxBuilder::end_call() {
  terms_.push_back(calls_.back());
  calls_.pop_back();
}

void SyntaxBuilder::push_operator(base::OpCode op) {
  ExpressionTerm term;
  term.kind = ExpressionTerm::ExpressionTermKind::op;
  term.op = op;
  terms_.push_back(term);
}

ParsedExpression SyntaxBuilder::take_expression(const char* begin) {
  return {std::exchange(terms_, {}), span(begin, token_end_)};
}

CardField& SyntaxBuilder::add(CardField::CardFieldKind kind, const char* begin, const char* end) {
  CardField& field = fields_.emplace_back();
  field.kind = kind;
  field.span = span(begin, end);
  return field;
}

bool SyntaxBuilder::field_end(const char* p, const char* last) {
  if (p >= last || is_blank(*p) || can_end_line(*p) || *p == ',' || *p == '=') {
    return true;
  }
  const char* end = scan_token(p, last);
  const std::string_view rest(p, end == p ? p + 1 : end);
  const bool arithmetic = std::string_view("*/+-^<>").find(*p) != std::string_view::npos;
  const bool fortran = (*p == '-' || *p == '+') && end - p > 1 && is_digit(p[1]) &&
                       fields_.back().kind == CardField::CardFieldKind::number;
  if (fortran) {
    const char* begin = origin_ + fields_.back().span.begin;
    return fail(span(begin, end), "E103",
                fmt::format("'{}': a Fortran exponent, or two numbers without a blank",
                            std::string_view(begin, end)),
                "write 1.5e-3, or 1.5 -3, or (1.5-3)");
  }
  const std::string slip(foreign_character_hint(origin_, p, last));
  return fail(span(p, p + rest.size()), "E102", fmt::format("unexpected '{}'", rest),
              arithmetic ? "an expression stands in parentheses" : slip);
}

bool SyntaxBuilder::signed_number(const char*& p, const char* last, ExpressionTerm& term) {
  const char* begin = p;
  const bool negative = *p == '-';
  const char* digits = *p == '-' || *p == '+' ? p + 1 : p;
  const ScannedNumber n = scan_number(digits, last);
  if (n.error == NumberError::absent) {
    return false;
  }
  if (n.error != NumberError::none) {
    return bad_number(begin, n.end, last, static_cast<int>(n.error));
  }
  p = n.end;
  term.value = negative ? -n.value : n.value;
  term.span = span(begin, p);
  return read_unit(p, last, term.unit);
}

bool SyntaxBuilder::parse_number_field(const char*& p, const char* last, bool in_row) {
  const char* begin = p;
  ExpressionTerm term;
  if (p >= last || !signed_number(p, last, term)) {
    return false;
  }
  CardField& field = add(CardField::CardFieldKind::number, begin, p);
  field.expression = {{term}, field.span};
  const char* colon = skip_blanks_and_comments(p, last);
  if (in_row && colon < last && *colon == ':') {
    p = begin;
    return field_range(p, last);
  }
  return field_end(p, last);
}

bool SyntaxBuilder::whole_number(const char*& p, const char* last, base::Label& value) {
  p = skip_blanks_and_comments(p, last);
  const auto [end, failed] = std::from_chars(p, last, value);
  if (failed != std::errc{} || (end < last && (is_name_char(*end) || *end == '.'))) {
    const char* stop = scan_token(p, last);
    return fail(span(p, stop), "E103", "a range needs whole numbers",
                "first : last, or first : last : step");
  }
  p = end;
  return true;
}

bool SyntaxBuilder::field_range(const char*& p, const char* last) {
  CardField& field = fields_.back();
  field.kind = CardField::CardFieldKind::range;
  const char* begin = p;
  int count = 0;
  while (true) {
    if (!whole_number(p, last, field.range[static_cast<std::size_t>(count)])) {
      return false;
    }
    field.span = span(begin, p);
    const char* next = skip_blanks_and_comments(p, last);
    if (++count == 3 || next >= last || *next != ':') {
      break;
    }
    p = next + 1;
  }
  if (field.range[2] < 1 || field.range[1] < field.range[0]) {
    return fail(field.span, "E103", "an empty range", "first : last : step, with step >= 1");
  }
  return field_end(p, last);
}

bool SyntaxBuilder::quantity(const char*& p, const char* last, const char* begin) {
  CardField field;
  field.kind = CardField::CardFieldKind::quantity;
  field.text = to_upper(std::string_view(begin, p));
  ++p; // (
  const char* first = skip_blanks_and_comments(p, last);
  while (first < last && *first != ')') {
    p = first;
    if (*p == '*') { // alone it stands for all of a kind
      ExpressionTerm all;
      all.kind = ExpressionTerm::ExpressionTermKind::name;
      all.span = span(p, p + 1);
      field.arguments.push_back({{all}, all.span});
      ++p;
    } else {
      if (!read_expression(p, last, *this)) {
        return false;
      }
      field.arguments.push_back(take_expression(first));
    }
    p = skip_blanks_and_comments(p, last);
    if (p >= last || *p != ',') {
      break;
    }
    first = skip_blanks_and_comments(p + 1, last);
    if (first >= last || *first == ')') {
      fail_expected(first, last, "an argument");
      return false;
    }
  }
  p = skip_blanks_and_comments(p, last);
  if (p >= last || *p != ')') {
    fail_expected(p, last, "')' or ','");
    return false;
  }
  ++p;
  field.span = span(begin, p);
  fields_.push_back(std::move(field));
  return field_end(p, last);
}

bool SyntaxBuilder::parse_name_field(const char*& p, const char* last, bool in_row) {
  const char* begin = p;
  const bool minus = in_row && p < last && *p == '-';
  const char* first = minus ? p + 1 : p;
  const char* end = scan_qualified_name(first, last);
  if (end == first) {
    return false;
  }
  p = end;
  if (in_row && !minus && p < last && *p == '(') {
    return quantity(p, last, begin);
  }
  CardField& field =
      add(minus ? CardField::CardFieldKind::minus_name : CardField::CardFieldKind::name, begin, p);
  field.text = to_upper(std::string_view(first, end));
  if (p<last&& static_cast<unsigned char>(*p)> 127) {
    const char* stop = scan_token(begin, last);
    return fail(span(begin, stop), "E117",
                fmt::format("'{}': a name has letters a-z, digits and _ only",
                            std::string_view(begin, stop)));
  }
  return field_end(p, last);
}

bool SyntaxBuilder::parse_text_field(const char*& p, const char* last) {
  if (p >= last || *p != '\'') {
    return false;
  }
  const char* end = scan_token(p, last);
  if (end - p < 2 || end[-1] != '\'') {
    return fail(span(p, end), "E101", "expected the closing ' of the text, the line ends early");
  }
  add(CardField::CardFieldKind::text, p, end).text.assign(p + 1, end - 1);
  p = end;
  return field_end(p, last);
}

bool SyntaxBuilder::parse_expression_field(const char*& p, const char* last) {
  if (p >= last || *p != '(') {
    return false;
  }
  const char* begin = p;
  ++p;
  if (!read_expression(p, last, *this)) {
    return false;
  }
  p = skip_blanks_and_comments(p, last);
  if (p >= last || *p != ')') {
    fail_expected(p, last, "')'");
    return false;
  }
  ++p;
  if (!read_trailing_unit(p, last)) {
    return false;
  }
  CardField& field = add(CardField::CardFieldKind::expression, begin, p);
  field.expression = take_expression(begin);
  return field_end(p, last);
}

void SyntaxBuilder::note_field_separator(char c) {
  fields_.back().separator = c;
}

std::vector<CardField> SyntaxBuilder::take_fields() {
  return std::exchange(fields_, {});
}

} // namespace spricka::grammar
