// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/builder.hpp"

#include "grammar/lexeme.hpp"

#include <charconv>
#include <utility>

#include <fmt/format.h>

namespace spricka::grammar {

namespace {
constexpr int k_deepest = 100; ///< nested brackets; keeps the recursive rules off the stack's end

// [unit]; none is fine.
bool read_unit(const char*& p, const char* last, base::SourceSpan& found,
               FirstSyntaxError& errors) {
  if (p >= last || *p != '[') {
    return true;
  }
  const char* q = p + 1;
  while (q < last && *q != ']' && *q != '\n') {
    ++q;
  }
  if (q >= last || *q != ']') {
    return errors.record_error(errors.span(p, q), "E101",
                               "expected ']' after the unit, the line ends early");
  }
  found = errors.span(p + 1, q);
  p = q + 1;
  return true;
}

bool read_signed_number(const char*& p, const char* last, ExpressionTerm& term,
                        FirstSyntaxError& errors) {
  const char* begin = p;
  const bool negative = *p == '-';
  const char* digits = *p == '-' || *p == '+' ? p + 1 : p;
  const ScannedNumber n = scan_number(digits, last);
  if (n.error == NumberError::absent) {
    return false;
  }
  if (n.error != NumberError::none) {
    return errors.record_bad_number(begin, n.end, last, n.error);
  }
  p = n.end;
  term.value = negative ? -n.value : n.value;
  term.span = errors.span(begin, p);
  return read_unit(p, last, term.unit, errors);
}

bool read_whole_number(const char*& p, const char* last, base::Label& value,
                       FirstSyntaxError& errors) {
  p = skip_blanks_and_comments(p, last);
  const auto [end, failed] = std::from_chars(p, last, value);
  if (failed != std::errc{} || (end < last && (is_name_char(*end) || *end == '.'))) {
    const char* stop = scan_token(p, last);
    return errors.record_error(errors.span(p, stop), "E103", "a range needs whole numbers",
                               "first : last, or first : last : step");
  }
  p = end;
  return true;
}

} // namespace

bool SyntaxBuilder::read_number(const char*& p, const char* last) {
  const ScannedNumber n = scan_number(p, last);
  if (n.error == NumberError::absent) {
    return false;
  }
  if (n.error != NumberError::none) {
    return errors.record_bad_number(p, n.end, last, n.error);
  }
  ExpressionTerm term;
  term.value = n.value;
  term.span = errors.span(p, n.end);
  p = n.end;
  if (!read_unit(p, last, term.unit, errors)) {
    return false;
  }
  token_end_ = p;
  terms_.push_back(term);
  return true;
}

bool SyntaxBuilder::read_trailing_unit(const char*& p, const char* last) {
  ExpressionTerm term;
  term.kind = ExpressionTerm::ExpressionTermKind::scale;
  if (!read_unit(p, last, term.unit, errors)) {
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
    return errors.record_error(p < last ? errors.span(p, p + 1) : errors.span(p - 1, p), "E102",
                               "the expression is nested too deeply");
  }
  return true;
}

void SyntaxBuilder::push_name(const char* begin, const char* end) {
  ExpressionTerm term;
  term.kind = ExpressionTerm::ExpressionTermKind::name;
  term.span = errors.span(begin, end);
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
  return {std::exchange(terms_, {}), errors.span(begin, token_end_)};
}

CardField& SyntaxBuilder::add(CardField::CardFieldKind kind, const char* begin, const char* end) {
  CardField& field = fields_.emplace_back();
  field.kind = kind;
  field.span = errors.span(begin, end);
  return field;
}

bool SyntaxBuilder::parse_number_field(const char*& p, const char* last, bool in_row) {
  const char* begin = p;
  ExpressionTerm term;
  if (p >= last || !read_signed_number(p, last, term, errors)) {
    return false;
  }
  CardField& field = add(CardField::CardFieldKind::number, begin, p);
  field.expression = {{term}, field.span};
  const char* colon = skip_blanks_and_comments(p, last);
  if (in_row && colon < last && *colon == ':') {
    p = begin;
    return field_range(p, last);
  }
  return errors.check_field_end(p, last, fields_.back());
}

bool SyntaxBuilder::field_range(const char*& p, const char* last) {
  CardField& field = fields_.back();
  field.kind = CardField::CardFieldKind::range;
  const char* begin = p;
  int count = 0;
  while (true) {
    if (!read_whole_number(p, last, field.range[static_cast<std::size_t>(count)], errors)) {
      return false;
    }
    field.span = errors.span(begin, p);
    const char* next = skip_blanks_and_comments(p, last);
    if (++count == 3 || next >= last || *next != ':') {
      break;
    }
    p = next + 1;
  }
  if (field.range[2] < 1 || field.range[1] < field.range[0]) {
    return errors.record_error(field.span, "E103", "an empty range",
                               "first : last : step, with step >= 1");
  }
  return errors.check_field_end(p, last, fields_.back());
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
      all.span = errors.span(p, p + 1);
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
      errors.record_expected(first, last, "an argument");
      return false;
    }
  }
  p = skip_blanks_and_comments(p, last);
  if (p >= last || *p != ')') {
    errors.record_expected(p, last, "')' or ','");
    return false;
  }
  ++p;
  field.span = errors.span(begin, p);
  fields_.push_back(std::move(field));
  return errors.check_field_end(p, last, fields_.back());
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
  if (p != last && static_cast<unsigned char>(*p) > 127) {
    const char* stop = scan_token(begin, last);
    return errors.record_error(errors.span(begin, stop), "E117",
                               fmt::format("'{}': a name has letters a-z, digits and _ only",
                                           std::string_view(begin, stop)));
  }
  return errors.check_field_end(p, last, fields_.back());
}

bool SyntaxBuilder::parse_text_field(const char*& p, const char* last) {
  if (p >= last || *p != '\'') {
    return false;
  }
  const char* end = scan_token(p, last);
  if (end - p < 2 || end[-1] != '\'') {
    return errors.record_error(errors.span(p, end), "E101",
                               "expected the closing ' of the text, the line ends early");
  }
  add(CardField::CardFieldKind::text, p, end).text.assign(p + 1, end - 1);
  p = end;
  return errors.check_field_end(p, last, fields_.back());
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
    errors.record_expected(p, last, "')'");
    return false;
  }
  ++p;
  if (!read_trailing_unit(p, last)) {
    return false;
  }
  CardField& field = add(CardField::CardFieldKind::expression, begin, p);
  field.expression = take_expression(begin);
  return errors.check_field_end(p, last, fields_.back());
}

void SyntaxBuilder::note_field_separator(char c) {
  fields_.back().separator = c;
}

std::vector<CardField> SyntaxBuilder::take_fields() {
  return std::exchange(fields_, {});
}

} // namespace spricka::grammar
