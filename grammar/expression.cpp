// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/builder.hpp"
#include "grammar/terminals.hpp"

#include <array>

namespace spricka::grammar {

namespace {

template <char C1, char C2>
bool take_two(const char*& p, const char* last, SyntaxBuilder& /*builder*/) {
  if (last - p < 2 || p[0] != C1 || p[1] != C2) {
    return false;
  }
  p = skip_blanks_and_comments(p + 2, last);
  return true;
}

bool is_word(const char* p, const char* last, std::string_view upper_word) {
  const char* end = scan_name(p, last);
  return to_upper(std::string_view(p, end)) == upper_word;
}

template <char... Letters>
bool take_word(const char*& p, const char* last, SyntaxBuilder& /*builder*/) {
  constexpr std::array<char, sizeof...(Letters)> word{Letters...};
  if (!is_word(p, last, {word.data(), word.size()})) {
    return false;
  }
  p = skip_blanks_and_comments(p + word.size(), last);
  return true;
}

bool take_number(const char*& p, const char* last, SyntaxBuilder& builder) {
  if (!builder.read_number(p, last)) {
    return false;
  }
  p = skip_blanks_and_comments(p, last);
  return true;
}

bool take_name(const char*& p, const char* last, SyntaxBuilder& builder) {
  const char* end = scan_qualified_name(p, last);
  if (end == p || is_word(p, last, "AND") || is_word(p, last, "OR")) {
    return false;
  }
  builder.push_name(p, end);
  p = skip_blanks_and_comments(end, last);
  return true;
}

bool open_call(const char*& p, const char* last, SyntaxBuilder& builder) {
  return match_character<'('>(p, last, builder) && builder.begin_call();
}

bool count_argument(const char*& /*p*/, const char* /*last*/, SyntaxBuilder& builder) {
  builder.add_argument();
  return true;
}

bool close_call(const char*& p, const char* last, SyntaxBuilder& builder) {
  if (p >= last || *p != ')') {
    return false;
  }
  builder.close(++p);
  builder.end_call();
  p = skip_blanks_and_comments(p, last);
  return true;
}

bool close_unit(const char*& p, const char* last, SyntaxBuilder& builder) {
  if (p >= last || *p != ')') {
    return false;
  }
  ++p;
  if (!builder.read_trailing_unit(p, last)) {
    return false;
  }
  p = skip_blanks_and_comments(p, last);
  return true;
}

bool go_deeper(const char*& p, const char* last, SyntaxBuilder& builder) {
  return builder.enter_nesting(p, last);
}

bool come_back(const char*& /*p*/, const char* /*last*/, SyntaxBuilder& builder) {
  builder.leave_nesting();
  return true;
}

template <base::OpCode O>
bool emit(const char*& /*p*/, const char* /*last*/, SyntaxBuilder& builder) {
  builder.push_operator(O);
  return true;
}

template <base::OpCode O> constexpr Terminal put{"an operator", emit<O>};

const Terminal number{"a number", take_number};
const Terminal name{"a name", take_name};
const Terminal plus{"'+'", match_character<'+'>};
const Terminal minus{"'-'", match_character<'-'>};
const Terminal times{"'*'", match_character<'*'>};
const Terminal over{"'/'", match_character<'/'>};
const Terminal caret{"'^'", match_character<'^'>};
const Terminal comma{"','", match_character<','>};
const Terminal open{"'('", match_character<'('>};
const Terminal close{"')'", close_unit};
const Terminal less{"'<'", match_character<'<'>};
const Terminal greater{"'>'", match_character<'>'>};
const Terminal less_equal{"'<='", take_two<'<', '='>};
const Terminal greater_equal{"'>='", take_two<'>', '='>};
const Terminal equal{"'=='", take_two<'=', '='>};
const Terminal word_and{"and", take_word<'A', 'N', 'D'>};
const Terminal word_or{"or", take_word<'O', 'R'>};
const Terminal call_open{"'('", open_call};
const Terminal call_close{"')' or ','", close_call};
const Terminal argument_end{"an argument", count_argument};
const Terminal deeper{"an expression", go_deeper};
const Terminal back{"an expression", come_back};

// The names stand in messages; every right side of > is one of these or a terminal.
const x3::rule<class expression_id> expression = "an expression";
const x3::rule<class comparison_id> comparison = "an expression";
const x3::rule<class sum_id> sum = "an expression";
const x3::rule<class product_id> product = "a number, a name or '('";
const x3::rule<class factor_id> factor = "a number, a name or '('";
const x3::rule<class primary_id> primary = "a number, a name or '('";
const x3::rule<class argument_id> argument = "an argument";

using base::OpCode;

const auto expression_def = comparison >> (+(word_and > comparison > put<OpCode::logical_and>) |
                                           *(word_or > comparison > put<OpCode::logical_or>));
const auto comparison_def = sum >> -((less_equal > sum > put<OpCode::less_equal>) |
                                     (greater_equal > sum > put<OpCode::greater_equal>) |
                                     (equal > sum > put<OpCode::equal>) |
                                     (less > sum > put<OpCode::less>) |
                                     (greater > sum > put<OpCode::greater>));
const auto sum_def = product >> *((plus > product > put<OpCode::add>) |
                                  (minus > product > put<OpCode::subtract>));
const auto product_def = factor >> *((times > factor > put<OpCode::multiply>) |
                                     (over > factor > put<OpCode::divide>));
const auto factor_def = deeper >> ((minus > factor > put<OpCode::negate>) | (plus > factor) |
                                   (primary >> -(caret > factor > put<OpCode::power>))) >>
                        back;
const auto argument_def = expression >> argument_end;
const auto primary_def = number |
                         (name >> -(call_open > argument > *(comma > argument) > call_close)) |
                         (open > expression > close);

BOOST_SPIRIT_DEFINE(expression, comparison, sum, product, factor, primary, argument)

} // namespace

bool read_expression(const char*& p, const char* last, SyntaxBuilder& builder) {
  const char* begin = p = skip_blanks_and_comments(p, last);
  if (!parse_rule(expression, p, last, builder)) {
    builder.errors.record_expected(begin, last, "an expression");
    return false;
  }
  if (is_word(p, last, "AND") || is_word(p, last, "OR")) {
    const char* end = scan_name(p, last);
    return builder.errors.record_error(builder.errors.span(p, end), "E102",
                                       "'and' and 'or' stand on one level: set parentheses");
  }
  return true;
}

} // namespace spricka::grammar
