// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/csv.hpp"
#include "base/exit_codes.hpp"
#include "model/model.hpp"
#include "report/drawing/file.hpp"
#include "report/sweep_files.hpp"
#include "report/units_line.hpp"
#include "results/contact_result.hpp"
#include "results/k_quantities.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include <fmt/format.h>

namespace spricka::report {

namespace {

using results::SweepCell;
using results::SweepPoint;

const std::vector<SweepCell>* requested_of(const SweepPoint& point, const std::string& file) {
  const auto found = point.requested.find(file);
  return found == point.requested.end() ? nullptr : &found->second;
}

// Columns in the order in which the points bring them.
void add_columns(const std::vector<SweepCell>& cells, std::vector<std::string>& columns,
                 std::set<std::string>& known) {
  for (const SweepCell& cell : cells) {
    if (known.insert(cell.column_name()).second) {
      columns.push_back(cell.column_name());
    }
  }
}

std::string value_of(const std::vector<const std::vector<SweepCell>*>& lists,
                     const std::string& column) {
  for (const std::vector<SweepCell>* cells : lists) {
    for (const SweepCell& cell : *cells) {
      if (cell.column_name() == column) {
        return std::isfinite(cell.value) ? fmt::format("{}", cell.value) : "";
      }
    }
  }
  return {};
}

std::string unit_line(const model::Model& model, const results::SweepResult& sweep) {
  using enum base::Quantity;
  ColumnUnits units;
  const bool life = std::ranges::any_of(sweep.points, [](const SweepPoint& point) {
    return std::ranges::find(point.cells, "N", &SweepCell::quantity) != point.cells.end();
  });
  if (life) {
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
  return fmt::format("# units: {} as the deck writes them; {}\n", fmt::join(sweep.parameters, " "),
                     units.units_text(model.units));
}

std::string table(const model::Model& model, const results::SweepResult& sweep,
                  const std::string& file, bool all) {
  std::vector<std::string> columns;
  std::set<std::string> known;
  for (const SweepPoint& point : sweep.points) {
    if (all) {
      add_columns(point.cells, columns, known);
    }
  }
  for (const SweepPoint& point : sweep.points) {
    if (const auto* cells = requested_of(point, file)) {
      add_columns(*cells, columns, known);
    }
  }
  std::string text = unit_line(model, sweep);
  auto out = std::back_inserter(text);
  fmt::format_to(out, "{},point,status,exit_code,error,checks,passed{}{}\n",
                 fmt::join(sweep.parameters, ","), columns.empty() ? "" : ",",
                 fmt::join(columns, ","));
  for (const SweepPoint& point : sweep.points) {
    fmt::format_to(out, "{},{},{},{},{},{},{}", fmt::join(point.values, ","), point.folder,
                   status_word(point), base::exit_code(point.outcome), base::csv_field(point.error),
                   point.checks, point.passed);
    std::vector<const std::vector<SweepCell>*> lists;
    if (all) {
      lists.push_back(&point.cells);
    }
    if (const auto* cells = requested_of(point, file)) {
      lists.push_back(cells);
    }
    for (const std::string& column : columns) {
      fmt::format_to(out, ",{}", value_of(lists, column));
    }
    text += '\n';
  }
  return text;
}

} // namespace

std::string status_word(const SweepPoint& point) {
  return point.outcome == base::Outcome::done           ? "done"
         : point.outcome == base::Outcome::check_failed ? "check failed"
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
