// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/columns.hpp"
#include "report/topics/result_tables.hpp"

namespace spricka::report {

ReportTable checks_table(const results::RunResult& run) {
  using Check = results::CheckResult;
  const auto share = [](const Check& check, double value, const char* percent, const char* other) {
    return check.relative ? cell_text(100.0 * value, percent) : cell_text(value, other);
  };
  const auto found = [](const Check& check) { return check.trouble.empty(); };
  Columns<Check> columns;
  columns.words("check", &Check::text)
      .number("found", "",
              [=](const Check& c) { return found(c) ? format_six_digits(c.found) : "-"; })
      .number("wanted", "", &Check::wanted)
      .number(
          "error", "",
          [=](const Check& c) { return found(c) ? share(c, c.error, "{:+.3f} %", "{:.2e}") : "-"; })
      .number("tolerance", "",
              [=](const Check& c) { return share(c, c.tolerance, "{:.4g} %", "{:.4g}"); })
      .words("", [](const Check& c) { return c.passed ? "passed" : "FAILED"; })
      .words("source", [=](const Check& c) { return found(c) ? c.source : c.trouble; });
  return columns.table("Checks", run.checks);
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
