// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/script_table.hpp"

namespace spricka::report {

ReportTable script_table(const std::vector<results::ReportedScriptConstant>& constants) {
  ReportTable table{
      "Constants of geometry scripts",
      {{"script", "", true}, {"constant", "", true}, {"value", "", false}, {"from", "", true}},
      {}};
  for (const results::ReportedScriptConstant& c : constants) {
    table.rows.push_back({c.file, c.name, c.value, c.from});
  }
  return table;
}

std::string script_section(const std::vector<results::ReportedScriptConstant>& constants) {
  return constants.empty() ? "" : "\n" + to_text(script_table(constants));
}

} // namespace spricka::report
