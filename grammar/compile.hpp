// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "base/units.hpp"
#include "grammar/ast.hpp"

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

/// Expressions and units, the third pass: names are looked up, parameters folded to numbers.
namespace spricka::grammar {

/// What the names of an expression stand for. Keys are upper case.
struct ExpressionScope {
  const base::SourceTexts* sources = nullptr;
  base::UnitSystem units;
  std::map<std::string, double, std::less<>> values;
  /// Where the unit stands of a parameter that is a number with a unit, or another such parameter.
  std::map<std::string, base::SourceSpan, std::less<>> units_of = {};
  /// Parameters that numbers with units went into, but are no such number themselves.
  std::set<std::string, std::less<>> made_of_units = {};
  std::set<std::string, std::less<>> poisoned; ///< defined by a bad line: their use is not reported
  bool incomplete = false; ///< an include is missing: unknown names are not reported
};

/// Whether an expression may use x y z rho theta.
enum class AllowedVariables { none, position };

/// A word of expressions, for the help: how it is written and what it is.
struct ExpressionFunctionText {
  std::string_view name; ///< upper case
  std::string_view form;
  std::string_view doc;
};
/// The functions of expressions with their forms, in the order of the help.
std::vector<ExpressionFunctionText> expression_functions();

/// What to write for a function that there is not, by its name in upper case; empty: nobody knows.
std::string unknown_function_hint(std::string_view name);

/// Names that no parameter may have: functions, pi, x y z rho theta, and, or.
bool is_reserved_name(std::string_view upper_name);

/// The expression with everything known folded away; literals with a unit become deck units. Empty
/// after an error (reported, unless a poisoned name is the cause). Constants are finite.
std::optional<base::CompiledExpression> compile_expression(const ParsedExpression& expression,
                                                           const ExpressionScope& scope,
                                                           AllowedVariables fields,
                                                           base::Diagnostics& diagnostics);

/// compile_expression() of an expression without fields, as its value.
std::optional<double> evaluate_constant(const ParsedExpression& expression,
                                        const ExpressionScope& scope,
                                        base::Diagnostics& diagnostics);

/// Whether an expression ends in a comparison, and or or; a number would be a condition by accident
/// only.
bool is_condition(const ParsedExpression& expression);

/// The unit that the whole value is given in: `0.084[mm]`, `(E/2)[GPa]`; invalid for a bare one.
base::SourceSpan explicit_unit_span(const ParsedExpression& expression);

/// The same, and for an expression that is a parameter alone the unit that was given there.
base::SourceSpan explicit_or_parameter_unit_span(const ParsedExpression& expression,
                                                 const ExpressionScope& scope);

/// Whether a unit stands anywhere in an expression or in the parameters it is made of, so that its
/// value is in deck units.
bool has_unit(const ParsedExpression& expression, const ExpressionScope& scope);

} // namespace spricka::grammar
