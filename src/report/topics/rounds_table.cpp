// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/rounds_table.hpp"

#include <string>
#include <vector>

#include <fmt/format.h>

namespace spricka::report {

ReportTable tolerance_rounds_table(const results::RunResult& run, bool times) {
  ReportTable table{"K to a tolerance",
                    {{"round", "", false},
                     {"freedoms", "", false},
                     {"cpu", "s", false},
                     {"bar", "%", false},
                     {"wanted", "%", false},
                     {"largest bar", "", true},
                     {"then made finer", "", true}},
                    {}};
  for (const results::ToleranceRound& round : run.rounds) {
    table.rows.push_back({fmt::format("{}", round.number), fmt::format("{}", round.unknowns),
                          fmt::format("{:.2f}", round.cpu),
                          fmt::format("{:.3g}", 100.0 * round.bar),
                          fmt::format("{:.3g}", 100.0 * round.wanted), round.worst, round.next});
  }
  if (!times) {
    table.columns.erase(table.columns.begin() + 2);
    for (std::vector<std::string>& row : table.rows) {
      row.erase(row.begin() + 2);
    }
  }
  return table;
}

} // namespace spricka::report
