// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/load_table.hpp"

#include <fmt/format.h>

namespace spricka::report {

ReportTable load_table(const std::vector<results::LoadTotal>& loads, const LoadTableUnits& form) {
  const std::string moment = form.force_unit + " " + form.length_unit;
  const int first_moment = form.dim == 3 ? 0 : 2; // in the plane about z alone
  ReportTable table{
      "Load cases: totals with factor 1 (moments about the origin; without loads on crack faces)",
      {{"case", "", true}},
      {}};
  for (int d = 0; d < form.dim; ++d) {
    table.columns.push_back({fmt::format("F{}", "xyz"[d]), form.force_unit, false});
  }
  for (int d = first_moment; d < 3; ++d) {
    table.columns.push_back({fmt::format("M{}", "xyz"[d]), moment, false});
  }
  const auto number = [](double v) { return fmt::format("{:.6g}", v); };
  for (const results::LoadTotal& load : loads) {
    std::vector<std::string> row{load.load_case};
    for (int d = 0; d < form.dim; ++d) {
      row.push_back(number(load.force[d]));
    }
    for (int d = first_moment; d < 3; ++d) {
      row.push_back(number(load.moment[d]));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

} // namespace spricka::report
