// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "grammar/ast.hpp"
#include "grammar/syntax_errors.hpp"

#include <cstdint>
#include <vector>

namespace spricka::grammar {

/// Receives what the X3 rules recognise. The rules are attribute-less and never go back behind an
/// emitted piece, so nothing here has to be undone. Its methods return false when the piece is
/// refused; the reason is then in `errors`.
class SyntaxBuilder {
public:
  SyntaxBuilder(std::int32_t file, const char* origin) : errors(file, origin) {}

  FirstSyntaxError errors;
  CardHeader card;                ///< the header being read
  ParameterAssignment assignment; ///< the assignment being read

  // Expressions.
  bool read_number(const char*& p, const char* last);        ///< unsigned, with its unit
  bool read_trailing_unit(const char*& p, const char* last); ///< [unit] after ) ; absent is fine
  bool enter_nesting(const char* p, const char* last);       ///< one level deeper
  void leave_nesting() { --depth_; }
  /// A name in the expression: variable, parameter or, with begin_call, function.
  void push_name(const char* begin, const char* end);
  bool begin_call(); ///< the last name is a function; its arguments follow
  void add_argument() { ++calls_.back().count; }
  void end_call();
  /// An operator behind its operands, as reverse Polish order has it.
  void push_operator(base::OpCode op);
  void close(const char* end) { token_end_ = end; }    ///< a bracket was the last token
  ParsedExpression take_expression(const char* begin); ///< from there to the last token

  // Fields of headers and rows.
  bool parse_number_field(const char*& p, const char* last, bool in_row);
  /// A name of a field, stored in upper case. In rows a minus may stand before it, and with a
  /// bracket behind it the name begins a quantity. False without a failure: there is none at `p`.
  bool parse_name_field(const char*& p, const char* last, bool in_row);
  /// A text of a field between quotes, without them. False where there is none or its end is
  /// missing.
  bool parse_text_field(const char*& p, const char* last);
  /// An expression of a field in brackets, with its unit. False where there is none or it has a
  /// mistake.
  bool parse_expression_field(const char*& p, const char* last);
  /// Notes which separator stands behind the last field.
  void note_field_separator(char c);
  std::vector<CardField> take_fields();

private:
  bool field_range(const char*& p, const char* last);
  bool quantity(const char*& p, const char* last, const char* begin);
  CardField& add(CardField::CardFieldKind kind, const char* begin, const char* end);

  const char* token_end_ = nullptr; ///< behind the last token of an expression
  int depth_ = 0;
  std::vector<ExpressionTerm> terms_;
  std::vector<ExpressionTerm> calls_;
  std::vector<CardField> fields_;
};

/// Reads one expression from `p` on (X3, expression.cpp). False: a syntax error, kept in
/// `builder.errors`. Stops before what cannot belong to it.
bool read_expression(const char*& p, const char* last, SyntaxBuilder& builder);

} // namespace spricka::grammar
