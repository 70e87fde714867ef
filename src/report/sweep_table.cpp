// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/exit_codes.hpp"
#include "model/model.hpp"
#include "report/drawing/columns.hpp"
#include "report/drawing/file.hpp"
#include "report/sweep_files.hpp"
#include "report/units_line.hpp"
#include "results/contact_result.hpp"
#include "results/k_quantities.hpp"
#include "results/result_unit.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include <fmt/format.h>

namespace spricka::report {

namespace {

using results::SweepPoint;
using results::SweepResultValue;

// A field with commas, quotes or line ends stands in quotes (RFC 4180); line ends become blanks.
std::string quoted(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  if (text.find_first_of(",\"") == std::string::npos) {
    return text;
  }
  std::string out = "\"";
  for (const char c : text) {
    out += c == '"' ? "\"\"" : std::string(1, c);
  }
  return out + "\"";
}

/// A row: a point of the sweep and the numbers it has by the names of their columns.
struct SweepRow {
  const SweepPoint& point;
  std::map<std::string, double> values;
};

/// The columns of cells, in the order in which the points bring them.
class SweepCellColumns {
public:
  explicit SweepCellColumns(const results::SweepResult& sweep) {
    for (const SweepPoint& point : sweep.points) {
      rows.push_back({point, {}});
    }
  }
  /// Adds the cells that `cells_of` gives of a point, or null.
  template <class CellsOf> void add(const CellsOf& cells_of) {
    for (SweepRow& row : rows) {
      const std::vector<SweepResultValue>* const cells = cells_of(row.point);
      for (std::size_t i = 0; cells != nullptr && i < cells->size(); ++i) {
        const std::string name = (*cells)[i].column_name();
        row.values.emplace(name, (*cells)[i].value);
        if (known_.insert(name).second) {
          names.push_back(name);
        }
      }
    }
  }

  std::vector<SweepRow> rows;
  std::vector<std::string> names;

private:
  std::set<std::string> known_;
};

std::string unit_line(const model::Model& model, const results::SweepResult& sweep) {
  using enum base::QuantityKind;
  ColumnUnits units;
  const bool has_life = std::ranges::any_of(sweep.points, [](const SweepPoint& point) {
    return std::ranges::find(point.cells, "N", &SweepResultValue::quantity) != point.cells.end();
  });
  const bool own_life = model.units.output.life != base::LifeUnit::as_counted;
  if (has_life && !own_life) {
    units.add_column(number, "N");
  }
  units.add_column(length, "a");
  units.add_column(length, "U");
  for (const results::KQuantity& q : results::k_quantities) {
    if (q.appears_in(results::in_sweep, 2)) { // of fronts in space a sweep has no K
      units.add_column(q.kind, q.name);
    }
  }
  for (const results::ContactQuantity& q : results::contact_quantities) {
    if (!q.sweep.empty()) {
      units.add_column(q.kind, std::string(q.sweep));
    }
  }
  units.add_column(stress, "S");
  units.add_column(force, "REACTION");
  return fmt::format("{} as the deck writes them; {}{}", fmt::join(sweep.parameters, " "),
                     has_life && own_life ? fmt::format("N [{}], ", results::life_unit_name(model))
                                          : "",
                     units.units_text(model.units));
}

std::string table(const model::Model& model, const results::SweepResult& sweep,
                  const std::string& file, bool all) {
  SweepCellColumns cells(sweep);
  if (all) {
    cells.add([](const SweepPoint& point) { return &point.cells; });
  }
  cells.add([&](const SweepPoint& point) {
    const auto found = point.requested.find(file);
    return found == point.requested.end() ? nullptr : &found->second;
  });
  Columns<SweepRow> columns;
  for (std::size_t p = 0; p < sweep.parameters.size(); ++p) {
    columns.exact(sweep.parameters[p], [p](const SweepRow& row) { return row.point.values[p]; });
  }
  columns.exact("point", [](const SweepRow& row) { return row.point.folder; })
      .exact("status", [](const SweepRow& row) { return sweep_point_status(row.point); })
      .exact("exit_code", [](const SweepRow& row) { return base::exit_code(row.point.outcome); })
      .exact("error", [](const SweepRow& row) { return quoted(row.point.error); })
      .exact("checks", [](const SweepRow& row) { return row.point.checks; })
      .exact("passed", [](const SweepRow& row) { return row.point.passed; });
  for (const std::string& name : cells.names) {
    columns.exact(name, [name](const SweepRow& row) {
      const auto found = row.values.find(name);
      return found != row.values.end() && std::isfinite(found->second)
                 ? std::optional(found->second)
                 : std::nullopt;
    });
  }
  return columns.csv(unit_line(model, sweep), cells.rows);
}

} // namespace

std::string sweep_point_status(const SweepPoint& point) {
  return point.outcome == base::ProgramOutcome::done           ? "done"
         : point.outcome == base::ProgramOutcome::check_failed ? "check failed"
                                                               : "failed";
}

void write_sweep_csv(const std::filesystem::path& file, const model::Model& model,
                     const results::SweepResult& sweep) {
  write_file(file, table(model, sweep, file.filename().string(), true));
}

void write_sweep_request_csv(const std::filesystem::path& file, const model::Model& model,
                             const results::SweepResult& sweep) {
  write_file(file, table(model, sweep, file.filename().string(), false));
}

} // namespace spricka::report
