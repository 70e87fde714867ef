// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/context.hpp"
#include "grammar/ast.hpp"

#include <string_view>

/// Warnings of numbers whose unit is probably another one than is meant.
namespace spricka::deck {

/// The first unit in an expression, or of a parameter in it, that is not the deck's own; invalid
/// where there is none.
base::SourceSpan find_foreign_unit(const grammar::ParsedExpression& expression,
                                   const grammar::ExpressionScope& scope);

/// Whether one of a unit is not one of the deck's own.
bool is_foreign_unit(const DeckContext& context, base::SourceSpan unit);

/// The warning for a bare number in the place of a value with that unit.
void warn_of_missing_unit(DeckContext& context, base::SourceSpan at, std::string_view name,
                          double value, base::SourceSpan unit);

/// Warns (W342) of an angle that is a whole number without a unit: radians of people are 0.5, pi/4
/// or 1.5708; 1, 2, 30 are degrees whose unit was forgotten.
void warn_of_whole_radians(DeckContext& context, base::SourceSpan at, std::string_view name,
                           double value);

/// Warns of inches with newtons and metres with pounds: nobody's stresses and K are in such a unit.
void warn_of_mixed_units(DeckContext& context, base::SourceSpan at, const base::UnitSystem& units);

} // namespace spricka::deck
