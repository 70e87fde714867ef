// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/model.hpp"
#include "report/drawing/columns.hpp"
#include "report/topics/result_tables.hpp"
#include "results/result_unit.hpp"

#include <vector>

#include <fmt/format.h>

namespace spricka::report {

namespace {

/// A line of $CHECK and what its numbers are written in.
struct CheckRow {
  const results::CheckResult& check;
  base::OutputUnit unit;
  [[nodiscard]] bool is_found() const { return check.trouble.empty(); }
  [[nodiscard]] std::string share(double value, const char* percent, const char* other) const {
    return check.relative ? cell_text(100.0 * value, percent)
                          : cell_text(unit.from_deck(value), other);
  }
};

} // namespace

ReportTable checks_table(const model::Model& model, const results::RunResult& run) {
  using Row = CheckRow;
  std::vector<Row> rows;
  for (std::size_t i = 0; i < run.checks.size(); ++i) {
    rows.push_back({run.checks[i], results::check_unit(model.units, model.checks.at(i).kind, run)});
  }
  Columns<Row> columns;
  columns.words("check", [](const Row& row) { return row.check.text; })
      .number("found", "",
              [](const Row& row) {
                return row.is_found() ? format_six_digits(row.unit.from_deck(row.check.found))
                                      : "-";
              })
      .number("wanted", "", [](const Row& row) { return row.unit.from_deck(row.check.wanted); });
  if (model.units.output.is_any()) {
    columns.words("unit", [](const Row& row) { return row.unit.name; });
  }
  columns
      .number("error", "",
              [](const Row& row) {
                return row.is_found() ? row.share(row.check.error, "{:+.3f} %", "{:.2e}") : "-";
              })
      .number("tolerance", "",
              [](const Row& row) { return row.share(row.check.tolerance, "{:.4g} %", "{:.4g}"); })
      .words("", [](const Row& row) { return row.check.passed ? "passed" : "FAILED"; })
      .words("source",
             [](const Row& row) { return row.is_found() ? row.check.source : row.check.trouble; });
  return columns.table("Checks", rows);
}

ReportTable run_log_table(const results::RunResult& run) {
  using results::LogLine;
  return Columns<LogLine>()
      .words("processor", &LogLine::processor)
      .number("cpu", "s", &LogLine::cpu, "{:.3f}")
      .number("wall", "s", &LogLine::wall, "{:.3f}")
      .words("", &LogLine::text)
      .table("Processors", run.log);
}

ReportTable tolerance_rounds_table(const results::RunResult& run, bool times) {
  using Round = results::ToleranceRound;
  Columns<Round> columns;
  columns.number("round", "", &Round::number).number("freedoms", "", &Round::unknowns);
  if (times) {
    columns.number("cpu", "s", &Round::cpu, "{:.2f}");
  }
  columns
      .number(
          "bar", "%", [](const Round& round) { return 100.0 * round.bar; }, "{:.3g}")
      .number(
          "wanted", "%", [](const Round& round) { return 100.0 * round.wanted; }, "{:.3g}")
      .words("largest bar", &Round::worst)
      .words("then made finer", &Round::next);
  return columns.table("K to a tolerance", run.rounds);
}

} // namespace spricka::report
