// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/load_table.hpp"

#include <fmt/format.h>

namespace spricka::report {

ReportTable load_table(const std::vector<results::LoadTotal>& loads, const LoadTableUnits& form) {
  const std::string moment = form.force_unit + " " + form.length_unit;
  ReportTable table{
      "Load cases: totals with factor 1 (moments about the origin; without loads on crack faces)",
      {{"case", "", true}, {"Fx", form.force_unit, false}, {"Fy", form.force_unit, false}},
      {}};
  if (form.dim == 3) {
    table.columns.push_back({"Fz", form.force_unit, false});
    table.columns.push_back({"Mx", moment, false});
    table.columns.push_back({"My", moment, false});
  }
  table.columns.push_back({"Mz", moment, false});
  const auto number = [](double v) { return fmt::format("{:.6g}", v); };
  for (const results::LoadTotal& load : loads) {
    std::vector<std::string> row{load.load_case, number(load.force.x()), number(load.force.y())};
    if (form.dim == 3) {
      row.push_back(number(load.force.z()));
      row.push_back(number(load.moment.x()));
      row.push_back(number(load.moment.y()));
    }
    row.push_back(number(load.moment.z()));
    table.rows.push_back(std::move(row));
  }
  return table;
}

} // namespace spricka::report
