// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/expression.hpp"
#include "base/id.hpp"
#include "base/source.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// The deck as it is written: syntax only, nothing is looked up yet. Names and keys are upper case
/// already; every piece keeps its place.
namespace spricka::grammar {

/// One step of an expression in reverse Polish order.
struct ExpressionTerm {
  enum class ExpressionTermKind : std::uint8_t {
    number, ///< push `value`, in `unit` if there is one
    name,   ///< push what the name stands for
    call,   ///< apply the function to `count` values
    op,     ///< apply `op`
    scale   ///< the value so far is in `unit`
  };
  ExpressionTermKind kind = ExpressionTermKind::number;
  base::OpCode op = base::OpCode::number;
  int count = 0;
  double value = 0.0;
  base::SourceSpan span;
  base::SourceSpan unit; ///< the text between [ and ]; invalid where there is none

  /// Whether it stands for a parameter or a variable.
  [[nodiscard]] bool is_name() const { return kind == ExpressionTermKind::name; }
};

struct ParsedExpression {
  std::vector<ExpressionTerm> terms;
  base::SourceSpan span;
};

/// A value in a header or a field of a data line.
struct CardField {
  enum class CardFieldKind : std::uint8_t {
    number,     ///< a literal, in `expression` as its only term
    expression, ///< in parentheses
    name,       ///< NAME or NET.NAME, in `text`
    minus_name, ///< -NAME, the name in `text`
    text,       ///< 'verbatim', in `text`
    range,      ///< first : last [: step]
    quantity    ///< NAME(arguments)
  };
  CardFieldKind kind = CardFieldKind::number;
  char separator = ' '; ///< what follows it in a row: ' ', ',' or '='
  base::SourceSpan span;
  std::string text;
  ParsedExpression expression;
  std::vector<ParsedExpression> arguments;
  std::array<base::Label, 3> range{0, 0, 1};

  /// Whether it is a name, without a minus.
  [[nodiscard]] bool is_name() const { return kind == CardFieldKind::name; }
  /// Whether it is a number or an expression in parentheses.
  [[nodiscard]] bool is_number_or_expression() const {
    return kind == CardFieldKind::number || kind == CardFieldKind::expression;
  }
};

struct HeaderParameter {
  std::string key;
  base::SourceSpan key_span;
  std::vector<CardField> values;
  base::SourceSpan span; ///< of the values
};

/// A header and the place of its data lines, which are read once the header is understood.
struct CardHeader {
  std::string name; ///< without the $
  base::SourceSpan name_span;
  std::vector<HeaderParameter> parameters;
  base::SourceSpan header;
  base::SourceSpan data;
  bool bad = false; ///< the header has a syntax error; `parameters` holds what came before it
};

struct DataRow {
  std::vector<CardField> fields;
  base::SourceSpan span;
};

struct ParameterAssignment {
  std::string name;    ///< upper case
  std::string written; ///< as in the deck
  base::SourceSpan name_span;
  ParsedExpression value;
};

} // namespace spricka::grammar
