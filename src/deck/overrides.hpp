// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/context.hpp"
#include "grammar/ast.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>

namespace spricka::deck {

/// Values that replace those of the deck's $PARAMETER cards: -D NAME=expression, and those of a
/// sweep's point. An expression is evaluated where the deck defines its parameter, so that it may
/// use what is defined before; other overrides it names come first, wherever they stand.
class ParameterOverrides {
public:
  /// Takes over and parses; the units must be known. Mistakes are reported.
  void read(DeckContext& context, const DeckReadOptions& options);

  /// Names are upper case here and below.
  [[nodiscard]] bool contains(const std::string& name) const { return table_.contains(name); }
  /// Empty after an error, which is reported.
  std::optional<double> value(DeckContext& context, const std::string& name);

  /// Where its unit stands; invalid for a bare number.
  [[nodiscard]] base::SourceSpan unit_span(const std::string& name) const;

  /// Warns when a bare number takes the place of a value that the deck gives with a unit: the
  /// number counts in the deck's own units.
  void warn_of_missing_unit(DeckContext& context, const grammar::ParameterAssignment& deck) const;
  /// Whether a unit went into it: in a sweep, whose values are in deck units, one of the deck's
  /// own.
  [[nodiscard]] bool has_unit(const DeckContext& context,
                              const grammar::ParameterAssignment& own) const;

  /// Reports the overrides of parameters that the deck does not have.
  void report_unknown_parameters(DeckContext& context, const std::set<std::string>& defined) const;

private:
  struct ParameterOverride {
    std::string written;
    base::SourceSpan span;
    std::optional<grammar::ParsedExpression> expression; ///< empty: a number, or a syntax error
    std::optional<double> value;
    bool evaluated = false;
    bool running = false; ///< being evaluated: named again it is a circle
  };

  void define(DeckContext& context, const std::string& name, const std::string& text);

  std::map<std::string, ParameterOverride> table_;
};

} // namespace spricka::deck
