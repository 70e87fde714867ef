// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "grammar/ast.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spricka::grammar {

/// Receives what the X3 rules recognise and keeps the first failure. The rules are attribute-less
/// and never go back behind an emitted piece, so nothing here has to be undone. Its methods return
/// false when the piece is refused; the reason is then in `failure`.
class SyntaxBuilder {
public:
  SyntaxBuilder(std::int32_t file, const char* origin) : file_(file), origin_(origin) {}

  struct SyntaxFailure {
    base::SourceSpan span;
    std::string code;
    std::string text;
    std::string hint;
  };
  std::optional<SyntaxFailure> failure;

  /// Keeps the first failure only; false, so that a terminal can return it.
  bool fail(base::SourceSpan place, std::string code, std::string text, std::string hint = {});
  /// "expected ..." at `at`, with the carets under the token there.
  void fail_expected(const char* at, const char* last, std::string_view what);
  /// Hands the first failure, if there is one, on as an error of the deck.
  void report_failure(base::Diagnostics& diagnostics) const;

  Card card;             ///< the header being read
  Assignment assignment; ///< the assignment being read

  /// The place in the source of the bytes from `begin` to `end`.
  [[nodiscard]] base::SourceSpan span(const char* begin, const char* end) const;

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
  bool signed_number(const char*& p, const char* last, ExpressionTerm& term);
  bool field_range(const char*& p, const char* last);
  bool whole_number(const char*& p, const char* last, base::Label& value);
  bool read_unit(const char*& p, const char* last, base::SourceSpan& found);
  bool bad_number(const char* begin, const char* end, const char* last, int error);
  bool field_end(const char* p, const char* last);
  bool quantity(const char*& p, const char* last, const char* begin);
  CardField& add(CardField::CardFieldKind kind, const char* begin, const char* end);

  std::int32_t file_;
  const char* origin_;
  const char* token_end_ = nullptr; ///< behind the last token of an expression
  int depth_ = 0;
  std::vector<ExpressionTerm> terms_;
  std::vector<ExpressionTerm> calls_;
  std::vector<CardField> fields_;
};

/// Reads one expression from `p` on (X3, expression.cpp). False: a syntax error, kept in
/// `builder.failure`. Stops before what cannot belong to it.
bool read_expression(const char*& p, const char* last, SyntaxBuilder& builder);

} // namespace spricka::grammar
