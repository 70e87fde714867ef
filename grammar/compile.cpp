// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/compile.hpp"

#include "base/diagnostics.hpp"
#include "grammar/lexeme.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace spricka::grammar {

namespace {

using base::OpCode;

struct Function {
  std::string_view name;
  OpCode op;
  int arguments; ///< min and max take more, too
  std::string_view form;
  std::string_view doc;
};

constexpr std::array<Function, 10> functions{{
    {"SQRT", OpCode::sqrt, 1, "sqrt(x)", "square root"},
    {"ABS", OpCode::abs, 1, "abs(x)", "amount without sign"},
    {"SIN", OpCode::sin, 1, "sin(x)", "sine of an angle in radians"},
    {"COS", OpCode::cos, 1, "cos(x)", "cosine"},
    {"TAN", OpCode::tan, 1, "tan(x)", "tangent"},
    {"ATAN2", OpCode::atan2, 2, "atan2(y, x)", "angle of the point (x, y), from -pi to pi"},
    {"EXP", OpCode::exp, 1, "exp(x)", "exponential"},
    {"LOG", OpCode::log, 1, "log(x)", "natural logarithm"},
    {"MIN", OpCode::min, 2, "min(a, b, ..)", "smallest of two or more"},
    {"MAX", OpCode::max, 2, "max(a, b, ..)", "largest of two or more"},
}};

constexpr std::array<std::pair<std::string_view, OpCode>, 5> variables{{{"X", OpCode::x},
                                                                        {"Y", OpCode::y},
                                                                        {"Z", OpCode::z},
                                                                        {"RHO", OpCode::rho},
                                                                        {"THETA", OpCode::theta}}};

const Function* find_function(std::string_view name) {
  const auto* const it = std::ranges::find(functions, name, &Function::name);
  return it == functions.end() ? nullptr : it;
}

std::optional<OpCode> find_variable(std::string_view name) {
  const auto* const it = std::find_if(variables.begin(), variables.end(),
                                      [&](const auto& v) { return v.first == name; });
  return it == variables.end() ? std::nullopt : std::optional(it->second);
}

int operands(OpCode op) {
  switch (op) {
  case OpCode::negate:
  case OpCode::sqrt:
  case OpCode::abs:
  case OpCode::sin:
  case OpCode::cos:
  case OpCode::tan:
  case OpCode::exp:
  case OpCode::log:
    return 1;
  default:
    return 2;
  }
}

class Compiler {
public:
  Compiler(const ExpressionScope& scope, AllowedVariables fields, base::Diagnostics& diagnostics)
      : scope_(scope), fields_(fields), diagnostics_(diagnostics) {}

  std::optional<base::CompiledExpression> run(const ParsedExpression& expression) {
    whole_ = expression.span;
    for (const ExpressionTerm& term : expression.terms) {
      add(term);
    }
    if (failed_) {
      return std::nullopt;
    }
    if (result_.code.size() == 1 && result_.is_constant() &&
        !std::isfinite(result_.code.front().value)) {
      diagnostics_.error(expression.span, "E206", "the value is not a finite number");
      return std::nullopt;
    }
    return std::move(result_);
  }

private:
  void add(const ExpressionTerm& term) {
    switch (term.kind) {
    case ExpressionTerm::ExpressionTermKind::number:
      push(term.value * (term.unit.valid() ? factor(term.unit) : 1.0));
      break;
    case ExpressionTerm::ExpressionTermKind::name:
      name(term);
      break;
    case ExpressionTerm::ExpressionTermKind::call:
      call(term);
      break;
    case ExpressionTerm::ExpressionTermKind::op:
      look_for_degrees(term.op, term.span);
      apply(term.op);
      break;
    case ExpressionTerm::ExpressionTermKind::scale:
      push(factor(term.unit));
      apply(OpCode::multiply);
      break;
    }
  }

  void push(double value) { result_.code.push_back({OpCode::number, value}); }

  // Appends the operation, or works it out at once where all operands are numbers. After a failure
  // the stack is kept in step, so that every mistake of the expression is found.
  void apply(OpCode op) {
    const auto n = static_cast<std::size_t>(operands(op));
    std::vector<base::ExpressionInstruction>& code = result_.code;
    const bool known =
        code.size() >= n &&
        std::all_of(code.end() - static_cast<std::ptrdiff_t>(n), code.end(),
                    [](const base::ExpressionInstruction& i) { return i.op == OpCode::number; });
    code.push_back({op, 0.0});
    if (known) {
      base::CompiledExpression part;
      part.code.assign(code.end() - static_cast<std::ptrdiff_t>(n + 1), code.end());
      code.resize(code.size() - n - 1);
      push(part(base::Vec3::Zero()));
    }
  }

  // A round number of more than a turn in a function of angles; or theta, which is -pi to pi,
  // beside what it never reaches.
  void look_for_degrees(OpCode op, base::SourceSpan at) {
    constexpr double turn = 2.0 * std::numbers::pi;
    const std::vector<base::ExpressionInstruction>& code = result_.code;
    const std::size_t n = code.size();
    const auto is = [&](std::size_t back, OpCode wanted) {
      return n >= back && code[n - back].op == wanted;
    };
    const bool last = is(1, OpCode::number);
    if ((op == OpCode::sin || op == OpCode::cos || op == OpCode::tan) && last) {
      const double angle = code[n - 1].value;
      if (std::abs(angle) > turn && 10.0 * angle == std::round(10.0 * angle)) {
        in_degrees(at, fmt::format("{} takes {:.6g} as radians", scope_.sources->text(at), angle),
                   angle);
      }
      return;
    }
    const bool sum = op == OpCode::add || op == OpCode::subtract;
    const bool compares = op == OpCode::less || op == OpCode::less_equal || op == OpCode::greater ||
                          op == OpCode::greater_equal || op == OpCode::equal;
    const bool theta = last ? is(2, OpCode::theta) || (is(2, OpCode::abs) && is(3, OpCode::theta))
                            : is(2, OpCode::number) && is(1, OpCode::theta);
    if ((sum || compares) && theta) {
      const double angle = code[n - (last ? 1 : 2)].value;
      if (std::abs(angle) > (sum ? turn : 0.5 * turn) * (1.0 + 1e-9)) {
        in_degrees(at, fmt::format("theta lies between -pi and pi: {:.6g} is beyond", angle),
                   angle);
      }
    }
  }

  void in_degrees(base::SourceSpan at, std::string text, double angle) {
    diagnostics_.warning(at.valid() ? at : whole_, "W355", std::move(text),
                         fmt::format("angles are radians; degrees are written {:.6g}[deg]", angle));
  }

  void name(const ExpressionTerm& term) {
    const std::string_view written = scope_.sources->text(term.span);
    const std::string upper = to_upper(written);
    if (const auto variable = find_variable(upper)) {
      if (fields_ == AllowedVariables::none) {
        fail(term.span, "E209", fmt::format("'{}' has no value here", written),
             "x y z rho theta stand in WHERE, ORDER and the values of $LOAD");
      }
      result_.code.push_back({*variable, 0.0});
    } else if (upper == "PI") {
      push(std::numbers::pi);
    } else if (const auto it = scope_.values.find(upper); it != scope_.values.end()) {
      push(it->second);
    } else {
      failed_ = true;
      push(1.0);
      if (!scope_.incomplete && !scope_.poisoned.contains(upper)) {
        unknown(term.span, written, upper);
      }
    }
  }

  void unknown(base::SourceSpan span, std::string_view written, const std::string& upper) {
    if (find_function(upper) != nullptr) {
      fail(span, "E203", fmt::format("'{}' is a function", written),
           fmt::format("write {}(...)", written));
      return;
    }
    std::vector<std::string> valid;
    if (!base::is_below_hint_error_limit(diagnostics_)) {
      fail(span, "E201", fmt::format("'{}' is not a parameter defined above", written));
      return;
    }
    for (const auto& [known, value] : scope_.values) {
      valid.push_back(known);
    }
    if (fields_ == AllowedVariables::position) {
      std::transform(variables.begin(), variables.end(), std::back_inserter(valid),
                     [](const auto& variable) { return std::string(variable.first); });
    }
    fail(span, "E201", fmt::format("'{}' is not a parameter defined above", written),
         base::make_spelling_hint(upper, valid));
  }

  void call(const ExpressionTerm& term) {
    const std::string_view written = scope_.sources->text(term.span);
    const Function* function = find_function(to_upper(written));
    const bool variadic =
        function != nullptr && (function->op == OpCode::min || function->op == OpCode::max);
    if (function != nullptr && (variadic ? term.count >= 2 : term.count == function->arguments)) {
      look_for_degrees(function->op, term.span);
      for (int i = 0; i < (variadic ? term.count - 1 : 1); ++i) {
        apply(function->op);
      }
      return;
    }
    if (function == nullptr) {
      fail(term.span, "E202", fmt::format("'{}' is not a function", written),
           unknown_function_hint(to_upper(written)));
    } else {
      fail(term.span, "E203",
           fmt::format("{} takes {}{} argument{}, not {}", written, function->arguments,
                       variadic ? " or more" : "", function->arguments == 1 ? "" : "s",
                       term.count));
    }
    push(1.0);
  }

  double factor(base::SourceSpan unit) {
    const std::string_view text = scope_.sources->text(unit);
    if (const auto known = base::parse_unit(text)) {
      return base::factor_to_deck_units(*known, scope_.units);
    }
    fail(unit, "E204", fmt::format("'{}' is not a unit", text),
         "m mm um in, N kN MN lbf kip, Pa kPa MPa GPa psi ksi, deg rad, with * / ^");
    return 1.0;
  }

  void fail(base::SourceSpan span, std::string code, std::string text, std::string hint = {}) {
    failed_ = true;
    diagnostics_.error(span, std::move(code), std::move(text), std::move(hint));
  }

  const ExpressionScope& scope_;
  AllowedVariables fields_;
  base::Diagnostics& diagnostics_;
  base::CompiledExpression result_;
  bool failed_ = false;
  base::SourceSpan whole_; ///< of the expression
};

} // namespace

std::string unknown_function_hint(std::string_view name) {
  for (const std::string_view choice :
       {"IF", "IFF", "IIF", "IFELSE", "WHERE", "STEP", "HEAVISIDE"}) {
    if (name == choice) {
      return "there is none that chooses: a comparison is 1 where it holds and 0 elsewhere, as in "
             "(5*(x > 2) + 1*(x <= 2))";
    }
  }
  std::vector<std::string> valid;
  std::ranges::transform(functions, std::back_inserter(valid),
                         [](const Function& f) { return std::string(f.name); });
  return base::make_spelling_hint(name, valid);
}

std::vector<ExpressionFunctionText> expression_functions() {
  std::vector<ExpressionFunctionText> texts;
  texts.reserve(functions.size());
  for (const Function& function : functions) {
    texts.push_back({function.name, function.form, function.doc});
  }
  return texts;
}

bool is_reserved_name(std::string_view upper_name) {
  return upper_name == "PI" || upper_name == "AND" || upper_name == "OR" ||
         find_function(upper_name) != nullptr || find_variable(upper_name).has_value();
}

std::optional<base::CompiledExpression> compile_expression(const ParsedExpression& expression,
                                                           const ExpressionScope& scope,
                                                           AllowedVariables fields,
                                                           base::Diagnostics& diagnostics) {
  return Compiler(scope, fields, diagnostics).run(expression);
}

std::optional<double> evaluate_constant(const ParsedExpression& expression,
                                        const ExpressionScope& scope,
                                        base::Diagnostics& diagnostics) {
  const auto compiled = compile_expression(expression, scope, AllowedVariables::none, diagnostics);
  if (!compiled) {
    return std::nullopt;
  }
  return (*compiled)(base::Vec3::Zero());
}

bool is_condition(const ParsedExpression& expression) {
  static constexpr std::array conditions{
      OpCode::less,  OpCode::less_equal,  OpCode::greater,   OpCode::greater_equal,
      OpCode::equal, OpCode::logical_and, OpCode::logical_or};
  return !expression.terms.empty() &&
         expression.terms.back().kind == ExpressionTerm::ExpressionTermKind::op &&
         std::ranges::find(conditions, expression.terms.back().op) != conditions.end();
}

base::SourceSpan explicit_unit_span(const ParsedExpression& expression) {
  if (expression.terms.empty()) {
    return {};
  }
  const ExpressionTerm& last = expression.terms.back();
  const bool whole =
      last.kind == ExpressionTerm::ExpressionTermKind::scale ||
      (last.kind == ExpressionTerm::ExpressionTermKind::number && expression.terms.size() == 1);
  // a scale inside the brackets, `(2*(E)[GPa])`, ends before the closing bracket
  const bool outside = last.unit.valid() && last.unit.end + 1 == expression.span.end;
  return whole && outside ? last.unit : base::SourceSpan{};
}

base::SourceSpan explicit_or_parameter_unit_span(const ParsedExpression& expression,
                                                 const ExpressionScope& scope) {
  if (expression.terms.size() != 1 || !expression.terms.front().is_name()) {
    return explicit_unit_span(expression);
  }
  const auto known = scope.units_of.find(to_upper(scope.sources->text(expression.terms[0].span)));
  return known == scope.units_of.end() ? base::SourceSpan() : known->second;
}

bool has_unit(const ParsedExpression& expression, const ExpressionScope& scope) {
  return std::any_of(expression.terms.begin(), expression.terms.end(),
                     [&](const ExpressionTerm& term) {
                       if (!term.is_name()) {
                         return term.unit.valid();
                       }
                       const std::string name = to_upper(scope.sources->text(term.span));
                       return scope.units_of.contains(name) || scope.made_of_units.contains(name);
                     });
}

} // namespace spricka::grammar
