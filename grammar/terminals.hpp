// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "grammar/builder.hpp"
#include "grammar/lexeme.hpp"

#include <functional>
#include <string>
#include <string_view>

#include <boost/spirit/home/x3.hpp>

/// What the X3 rules are made of. Only the sources of this room that hold rules include this file:
/// Spirit costs two seconds in each. Terminals are our own, because Spirit's character classes stop
/// the program at bytes above 127 and its numbers are not exactly rounded. They have no attributes
/// and tell the Builder what they met, so the rules need no semantic actions.
namespace spricka::grammar {

namespace x3 = boost::spirit::x3;

struct builder_tag;

struct Terminal : x3::parser<Terminal> {
  using attribute_type = x3::unused_type;
  static constexpr bool has_attribute = false;
  using Read = bool (*)(const char*& p, const char* last, SyntaxBuilder& builder);

  constexpr Terminal(const char* called, Read function) : name(called), read(function) {}

  /// Called by Spirit: reads with the builder of the context and moves `first` on only where it
  /// succeeds.
  template <class DeckContext, class RuleContext, class Attribute>
  bool parse(const char*& first, const char* const& last, const DeckContext& context, RuleContext&,
             Attribute&) const {
    const char* p = first;
    if (!read(p, last, x3::get<builder_tag>(context).get())) {
      return false;
    }
    first = p;
    return true;
  }

  const char* name; ///< stands in messages: "expected <name>"
  Read read;
};

/// One character, and the blanks after it.
template <char C>
bool match_character(const char*& p, const char* last, SyntaxBuilder& /*builder*/) {
  if (p >= last || *p != C) {
    return false;
  }
  p = skip_blanks_and_comments(p + 1, last);
  return true;
}

/// Runs `start` over [p, last); a failed expectation goes to the builder.
template <class Rule>
bool parse_rule(const Rule& start, const char*& p, const char* last, SyntaxBuilder& builder) {
  try {
    return x3::parse(p, last, x3::with<builder_tag>(std::ref(builder))[start]);
  } catch (const x3::expectation_failure<const char*>& failure) {
    builder.errors.record_expected(failure.where(), last, failure.which());
    return false;
  }
}

} // namespace spricka::grammar

template <> struct boost::spirit::x3::get_info<spricka::grammar::Terminal> {
  using result_type = std::string;
  std::string operator()(const spricka::grammar::Terminal& terminal) const { return terminal.name; }
};
