// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/context.hpp"
#include "grammar/lexeme.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

/// $REQUIRE: conditions on the deck's parameters, said in the deck's own words where they fail.
namespace spricka::deck {

namespace {

using grammar::CardField;

/// "d = 40, pin = 41": the parameters of an expression, each once.
std::string parameter_values(const DeckContext& c, const grammar::ParsedExpression& expression) {
  std::vector<std::string> names;
  std::string text;
  for (const grammar::ExpressionTerm& term : expression.terms) {
    const std::string written(term.is_name() ? c.sources.text(term.span) : "");
    const auto value = c.scope.values.find(grammar::to_upper(written));
    if (value != c.scope.values.end() && std::ranges::find(names, written) == names.end()) {
      names.push_back(written);
      text += fmt::format("{}{} = {:.6g}", text.empty() ? "" : ", ", written, value->second);
    }
  }
  return text;
}

void check_requirement(DeckContext& c, const grammar::DataRow& row) {
  const bool form = row.fields.size() == 2 && grammar::is_condition(row.fields[0].expression) &&
                    row.fields[1].kind == CardField::CardFieldKind::text;
  if (!form) {
    c.error(row.span, "E115", "a condition in parentheses and a text are expected",
            "(pin < bore) 'the pin is thinner than the bore'");
    return;
  }
  const CardField& first = row.fields.front();
  const std::optional<double> holds =
      grammar::evaluate_constant(first.expression, c.scope, c.diagnostics);
  if (holds && *holds == 0.0) {
    const std::string values = parameter_values(c, first.expression);
    c.error(first.span, "E123",
            fmt::format("{}{}{}", row.fields[1].text, values.empty() ? "" : ": ", values));
  }
}

} // namespace

bool check_requirements(DeckContext& context) {
  const std::size_t before = context.diagnostics.error_count();
  context.for_each_sound_card("REQUIRE", [&](const CheckedCard& card) {
    for (const grammar::DataRow& row : card.rows) {
      check_requirement(context, row);
    }
  });
  return context.diagnostics.error_count() == before;
}

} // namespace spricka::deck
