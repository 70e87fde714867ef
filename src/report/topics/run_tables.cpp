// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/result_tables.hpp"

#include <fmt/format.h>

namespace spricka::report {
namespace {} // namespace

ReportTable check_table(const results::RunResult& run) {
  ReportTable table{"Checks",
                    {{"check", "", true},
                     {"found", "", false},
                     {"wanted", "", false},
                     {"error", "", false},
                     {"tolerance", "", false},
                     {"", "", true},
                     {"source", "", true}},
                    {}};
  for (const results::CheckResult& check : run.checks) {
    const bool found = check.trouble.empty();
    const std::string error = check.relative ? fmt::format("{:+.3f} %", 100.0 * check.error)
                                             : fmt::format("{:.2e}", check.error);
    const std::string tolerance = check.relative ? fmt::format("{:.4g} %", 100.0 * check.tolerance)
                                                 : fmt::format("{:.4g}", check.tolerance);
    table.rows.push_back({check.text, found ? six_digits(check.found) : "-",
                          six_digits(check.wanted), found ? error : "-", tolerance,
                          check.passed ? "passed" : "FAILED",
                          found ? check.source : check.trouble});
  }
  return table;
}

ReportTable log_table(const results::RunResult& run) {
  ReportTable table{
      "Processors",
      {{"processor", "", true}, {"cpu", "s", false}, {"wall", "s", false}, {"", "", true}},
      {}};
  for (const results::LogLine& line : run.log) {
    table.rows.push_back({line.processor, fmt::format("{:.3f}", line.cpu),
                          fmt::format("{:.3f}", line.wall), line.text});
  }
  return table;
}

} // namespace spricka::report
