// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/unit_warnings.hpp"

#include "grammar/lexeme.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

template <class Wanted>
base::SourceSpan find_unit(const grammar::ParsedExpression& expression,
                           const grammar::ExpressionScope& scope, const Wanted& wanted) {
  for (const grammar::ExpressionTerm& term : expression.terms) {
    base::SourceSpan unit = term.unit;
    if (term.is_name()) {
      const auto known = scope.units_of.find(grammar::to_upper(scope.sources->text(term.span)));
      unit = known == scope.units_of.end() ? unit : known->second;
    }
    if (unit.valid() && wanted(unit)) {
      return unit;
    }
  }
  return {};
}

double factor_of(base::SourceSpan unit, const grammar::ExpressionScope& scope) {
  const std::optional<base::PhysicalUnit> known = base::parse_unit(scope.sources->text(unit));
  return known ? base::factor_to_deck_units(*known, scope.units) : 1.0;
}

} // namespace

bool is_foreign_unit(const DeckContext& context, base::SourceSpan unit) {
  return std::abs(factor_of(unit, context.scope) - 1.0) > 1e-12;
}

base::SourceSpan find_foreign_unit(const grammar::ParsedExpression& expression,
                                   const grammar::ExpressionScope& scope) {
  return find_unit(expression, scope, [&](base::SourceSpan unit) {
    return std::abs(factor_of(unit, scope) - 1.0) > 1e-12;
  });
}

void warn_of_missing_unit(DeckContext& context, base::SourceSpan at, std::string_view name,
                          double value, base::SourceSpan unit) {
  if (value == 0.0) {
    return;
  }
  const std::string_view word = context.sources.text(unit);
  const std::string_view written = context.sources.text(at);
  context.warning(at, "W464",
                  fmt::format("{} = {} counts in the deck's own units, where the deck gives {} in "
                              "[{}]: it is {:.6g}[{}]",
                              name, written, name, word, value / factor_of(unit, context.scope),
                              word),
                  fmt::format("write {}[{}], or the unit that is meant", written, word));
}

void warn_of_whole_radians(DeckContext& context, base::SourceSpan at, std::string_view name,
                           double value) {
  if (value == 0.0 || value != std::floor(value) ||
      context.sources.text(at).find('[') != std::string_view::npos) {
    return;
  }
  context.warning(at, "W342",
                  fmt::format("{}: {} is in radians, which are {:.4g} degrees", name, value,
                              value * 180.0 / std::numbers::pi),
                  fmt::format("degrees are written {}[deg]; {}[rad] says that radians are meant",
                              value, value));
}

void warn_of_mixed_units(DeckContext& context, base::SourceSpan at, const base::UnitSystem& units) {
  const bool inches = units.length_name == "in";
  const bool pounds = units.force_name == "lbf";
  if (inches != pounds) {
    context.warning(at, "W465",
                    fmt::format("lengths in {} and forces in {} make stresses in {}",
                                units.length_name, units.force_name, units.stress_name()),
                    inches ? "FORCE=LBF, or LENGTH=MM" : "LENGTH=IN, or FORCE=N");
  }
}

} // namespace spricka::deck
