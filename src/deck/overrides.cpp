// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/overrides.hpp"

#include "deck/unit_warnings.hpp"
#include "grammar/lexeme.hpp"
#include "grammar/parse.hpp"

#include <utility>
#include <vector>

#include <fmt/format.h>

namespace spricka::deck {

void ParameterOverrides::warn_of_missing_unit(DeckContext& context,
                                              const grammar::ParameterAssignment& deck) const {
  const ParameterOverride& entry = table_.at(deck.name);
  if (!entry.expression || grammar::has_unit(*entry.expression, context.scope)) {
    return;
  }
  const base::SourceSpan unit = find_foreign_unit(deck.value, context.scope);
  if (unit.valid() && entry.value) {
    deck::warn_of_missing_unit(context, entry.span, entry.written, *entry.value, unit);
  }
}

void ParameterOverrides::define(DeckContext& context, const std::string& name,
                                const std::string& text) {
  const std::int32_t file = context.sources.add_text(fmt::format("-D {}", name), text);
  const base::SourceSpan all{file, 0, static_cast<std::uint32_t>(text.size())};
  const std::string upper = grammar::to_upper(name);
  const char* const last = name.data() + name.size();
  const bool is_name = !name.empty() && grammar::scan_name(name.data(), last) == last;
  if (!is_name || grammar::is_reserved_name(upper)) {
    context.error(all, "E210", fmt::format("-D: '{}' cannot be the name of a parameter", name));
    return;
  }
  ParameterOverride entry;
  entry.written = name;
  entry.span = all;
  entry.expression = grammar::parse_expression(context.sources, all, context.diagnostics);
  entry.evaluated = !entry.expression;
  if (!table_.emplace(upper, std::move(entry)).second) {
    context.error(all, "E210", fmt::format("-D: {} is given twice", name));
  }
}

void ParameterOverrides::read(DeckContext& context, const DeckReadOptions& options) {
  for (const auto& [name, text] : options.defines) {
    define(context, name, text);
  }
  for (const auto& [name, entry] : table_) {
    context.overridden.insert(name);
  }
  for (const auto& [name, number] : options.sweep_values) {
    ParameterOverride entry;
    entry.written = name;
    entry.value = number;
    entry.evaluated = true;
    table_.emplace(grammar::to_upper(name), std::move(entry));
  }
}

std::optional<double> ParameterOverrides::value(DeckContext& context, const std::string& name) {
  ParameterOverride& entry = table_.at(name);
  if (entry.evaluated) {
    return entry.value;
  }
  if (entry.running) {
    context.error(entry.span, "E210", fmt::format("-D: {} is defined by itself", entry.written));
    entry.evaluated = true;
    return std::nullopt;
  }
  entry.running = true;
  for (const grammar::ExpressionTerm& term : entry.expression->terms) {
    if (!term.is_name()) {
      continue;
    }
    const std::string needed = grammar::to_upper(context.sources.text(term.span));
    if (!contains(needed)) {
      continue;
    }
    if (const std::optional<double> found = value(context, needed)) {
      context.scope.values[needed] = *found;
    } else {
      context.scope.poisoned.insert(needed);
    }
  }
  if (!entry.evaluated) {
    entry.value = grammar::evaluate_constant(*entry.expression, context.scope, context.diagnostics);
    entry.evaluated = true;
  }
  return entry.value;
}

base::SourceSpan ParameterOverrides::unit_span(const std::string& name) const {
  const std::optional<grammar::ParsedExpression>& expression = table_.at(name).expression;
  return expression ? grammar::explicit_unit_span(*expression) : base::SourceSpan();
}

bool ParameterOverrides::has_unit(const DeckContext& context,
                                  const grammar::ParameterAssignment& own) const {
  const std::optional<grammar::ParsedExpression>& expression = table_.at(own.name).expression;
  return grammar::has_unit(expression ? *expression : own.value, context.scope);
}

void ParameterOverrides::report_unknown_parameters(DeckContext& context,
                                                   const std::set<std::string>& defined) const {
  const std::vector<std::string> valid(defined.begin(), defined.end());
  for (const auto& [name, entry] : table_) {
    const bool syntax_error = entry.evaluated && !entry.value && !entry.expression;
    if (!defined.contains(name) && !syntax_error && entry.span.valid()) {
      context.error(entry.span, "E201",
                    fmt::format("-D: the deck has no parameter '{}'", entry.written),
                    base::make_spelling_hint(name, valid));
    }
  }
}

} // namespace spricka::deck
