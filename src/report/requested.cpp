// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/model.hpp"
#include "model/wanted_steps.hpp"
#include "report/drawing/columns.hpp"
#include "report/drawing/file.hpp"
#include "report/report.hpp"
#include "report/requested_values.hpp"
#include "report/topics/result_rows.hpp"
#include "report/units_line.hpp"
#include "results/k_quantities.hpp"
#include "results/output_word.hpp"

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace spricka::report {

namespace {

/// A row: one number of a request at the end of a step.
struct RequestedRow {
  const results::CrackLengthResult& increment;
  const results::LoadStepResult& step;
  const model::RequestedQuantity& request;
  RequestedValue of;
};

Columns<RequestedRow> requested_columns(const base::UnitSystem& units, int dim) {
  using Row = RequestedRow;
  Columns<Row> columns = step_columns<Row>();
  columns.exact("quantity", [](const Row& row) { return row.request.quantity; })
      .exact("name", [](const Row& row) { return row.request.name; })
      .fill_only_if([](const Row& row) { return row.of.where.has_value(); })
      .exact("node", [](const Row& row) { return row.of.where->first; });
  for (int c = 0; c < dim; ++c) {
    columns.exact(std::string(1, "xyz"[c]), units.output_length(),
                  [c](const Row& row) { return row.of.where->second[c]; });
  }
  columns.fill_only_if({});
  return columns.exact("component", [](const Row& row) { return row.of.component; })
      .exact("value", [units](const Row& row) {
        return base::output_unit(units, row.of.kind).from_deck(row.of.value);
      });
}

ColumnUnits column_units(std::string_view axes) {
  using enum base::QuantityKind;
  ColumnUnits units;
  for (const char axis : axes) {
    units.add_column(length, std::string(1, axis));
  }
  for (const char* what : {"A", "U", "GAP"}) {
    units.add_column(length, what);
  }
  units.add_column(stress, "P");
  units.add_column(stress, "S");
  units.add_column(stress_intensity, "K");
  units.add_column(force, "REACTION");
  for (const results::KQuantity& q : results::k_quantities) {
    // those of tips; K and its bars all begin with K
    if (q.appears_in(results::in_output, 2) && q.kind != stress_intensity) {
      units.add_column(q.kind, results::uppercase_column_name(q.name));
    }
  }
  return units;
}

} // namespace

void write_requested_csv(const std::filesystem::path& file, const model::Model& model,
                         const model::OutputFileRequest& output, const results::RunResult& run) {
  std::vector<RequestedRow> rows;
  for (const results::CrackLengthResult& increment : run.increments) {
    const bool last = &increment == &run.increments.back();
    for (const std::size_t s : model::output_step_indices(model, output, last)) {
      for (const model::RequestedQuantity& request : output.requests) {
        const results::LoadStepResult& step = increment.steps[s];
        for (RequestedValue& value : collect_requested_values(increment, step, request)) {
          rows.push_back({increment, step, request, std::move(value)});
        }
      }
    }
  }
  const std::string_view axes =
      std::string_view("xyz").substr(0, static_cast<std::size_t>(model.mesh.dim));
  write_file(file, requested_columns(model.units, model.mesh.dim)
                       .csv(column_units(axes).units_text(model.units), rows));
}

} // namespace spricka::report
