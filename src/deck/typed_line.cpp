// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/typed_line.hpp"

#include "deck/checks.hpp"
#include "grammar/parse.hpp"

#include <cstdint>
#include <vector>

namespace spricka::deck {

namespace {

// What stands in the reading of a deck before its steps and checks, without its mesh.
void fill_context(const model::Model& model, DeckContext& context) {
  context.scope.units = model.units;
  context.model.mesh.dim = model.mesh.dim;
  context.model.growth = model.growth;
  define_names_of_model(context, model);
}

// The line as the only row of a card; empty after an error.
std::optional<grammar::DataRow> read_row(const std::string& line, base::SourceTexts& sources,
                                         base::Diagnostics& diagnostics) {
  const std::int32_t file = sources.add_text("line", line + "\n");
  const base::SourceSpan whole{file, 0, static_cast<std::uint32_t>(line.size() + 1)};
  const std::vector<grammar::DataRow> rows = grammar::parse_data_rows(sources, whole, diagnostics);
  if (rows.size() != 1 && !diagnostics.has_errors()) {
    diagnostics.error(whole, "E115", "one data line is expected");
  }
  return diagnostics.has_errors() ? std::nullopt : std::optional(rows.front());
}

} // namespace

std::optional<model::Step> read_step_line(const model::Model& model, const std::string& line,
                                          base::SourceTexts& sources,
                                          base::Diagnostics& diagnostics) {
  const std::optional<grammar::DataRow> row = read_row(line, sources, diagnostics);
  if (!row) {
    return std::nullopt;
  }
  DeckContext context{sources, diagnostics};
  fill_context(model, context);
  model::Step step;
  read_step_row(context, *row, step);
  return diagnostics.has_errors() ? std::nullopt : std::optional(std::move(step));
}

std::optional<model::ResultCheck> read_result_request_line(const model::Model& model,
                                                           const std::string& line,
                                                           base::SourceTexts& sources,
                                                           base::Diagnostics& diagnostics) {
  const std::optional<grammar::DataRow> row = read_row(line, sources, diagnostics);
  if (!row) {
    return std::nullopt;
  }
  DeckContext context{sources, diagnostics};
  fill_context(model, context);
  CheckedCard card;
  card.spec = grammar::find_card("CHECK");
  card.span = row->span;
  return read_result_request(context, card, *row);
}

} // namespace spricka::deck
