// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/typed_line.hpp"

#include "deck/checks.hpp"
#include "grammar/lexeme.hpp"
#include "grammar/parse.hpp"

#include <cstdint>
#include <vector>

namespace spricka::deck {

namespace {

template <class Entities>
void define_names(NameTable& names, EntityKind kind, const Entities& entities) {
  for (std::size_t i = 0; i < entities.size(); ++i) {
    if (!entities[i].name.empty()) {
      names.define(entities[i].name, {kind, i, {}, {}, false});
    }
  }
}

// What stands in the reading of a deck before its steps and checks, without its mesh.
void fill_context(const model::Model& model, DeckContext& context) {
  context.scope.sources = &context.sources;
  context.scope.units = model.units;
  for (const auto& [name, value] : model.parameters) {
    context.scope.values.emplace(grammar::to_upper(name), value);
  }
  context.model.mesh.dim = model.mesh.dim;
  context.model.growth = model.growth;
  NameTable& names = context.names;
  define_names(names, EntityKind::load_case, model.cases);
  define_names(names, EntityKind::contact, model.contacts);
  define_names(names, EntityKind::crack, model.cracks);
  define_names(names, EntityKind::step, model.steps);
  names.define("NOW", {EntityKind::step, model.steps.size(), {}, {}, false});
  define_names(names, EntityKind::material, model.materials);
  define_names(names, EntityKind::path, model.load_paths);
  define_names(names, EntityKind::test, model.tests);
  define_names(names, EntityKind::net, model.nets);
  define_names(names, EntityKind::node_set, model.mesh.node_sets);
  define_names(names, EntityKind::element_set, model.mesh.element_sets);
  define_names(names, EntityKind::face_set, model.mesh.face_sets);
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
