// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/model.hpp"
#include "report/drawing/columns.hpp"
#include "report/drawing/file.hpp"
#include "report/report.hpp"
#include "report/topics/k_tables.hpp"
#include "report/topics/result_rows.hpp"
#include "report/units_line.hpp"

#include <algorithm>
#include <optional>
#include <vector>

namespace spricka::report {

namespace {

/// A node of a contact surface at the end of a step.
struct PressureRow : ContactRow {
  const results::ContactPoint& point;
};

} // namespace

void write_k_csv(const std::filesystem::path& file, const model::Model& model,
                 const results::RunResult& run) {
  ColumnUnits units;
  units.add_column(base::QuantityKind::number, "increment");
  Columns<FrontPointRow> columns = step_columns<FrontPointRow>();
  columns.exact("crack", [](const FrontPointRow& row) { return row.front.name; });
  for (const results::KQuantity* const q : shown_k_quantities(model, results::in_k_csv)) {
    columns.fill_only_if(
        [q](const FrontPointRow& row) { return q->is_given(row.front, row.point); });
    columns.exact(q->name, base::output_unit(model.units, q->kind),
                  [q](const FrontPointRow& row) { return q->extract_value(row.front, row.point); });
    // K1_bar and its like are made of K1 and K2
    const bool follows = q->is_quality_measure && q->kind == base::QuantityKind::stress_intensity;
    units.add_column(q->kind, follows ? "and what begins with them" : q->name);
  }
  write_file(file, columns.csv(units.units_text(model.units), front_point_rows(run.increments)));
}

void write_pressure_csv(const std::filesystem::path& file, const model::Model& model,
                        const results::RunResult& run) {
  const bool rubs = model::has_friction(model);
  ColumnUnits units;
  units.add_column(base::QuantityKind::number, "increment");
  Columns<PressureRow> columns = step_columns<PressureRow>();
  columns.exact("contact", [](const PressureRow& row) { return row.contact.name; });
  for (const results::ContactPointQuantity& q : results::point_quantities) {
    if (!q.appears_in(results::in_pressure_csv) || (q.friction && !rubs) ||
        model.mesh.dim < q.least_dim) {
      continue;
    }
    if (q.is_word()) {
      columns.exact(q.name, [q = &q](const PressureRow& row) {
        return results::display_word(row.point.*q->state);
      });
      continue;
    }
    columns.exact(q.name, base::output_unit(model.units, q.kind),
                  [q = &q](const PressureRow& row) { return q->extract_value(row.point); });
    units.add_column(q.kind, q.name);
  }
  std::vector<PressureRow> rows;
  for (const ContactRow& row : contact_rows(run.increments)) {
    if (!row.contact.mounted) {
      continue; // absent, not open: it has no pressure
    }
    for (const results::ContactPoint& point : row.contact.points) {
      rows.push_back({row, point});
    }
  }
  write_file(file, columns.csv(units.units_text(model.units), rows));
}

} // namespace spricka::report
