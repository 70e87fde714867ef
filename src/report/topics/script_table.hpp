// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "report/drawing/table.hpp"
#include "results/script_constant.hpp"

#include <string>
#include <vector>

namespace spricka::report {

/// The constants of geometry scripts: name, value, and whether the deck or the file has given it.
ReportTable script_table(const std::vector<results::ReportedScriptConstant>& constants);

/// The same as a section of the listing; empty if there are none.
std::string script_section(const std::vector<results::ReportedScriptConstant>& constants);

} // namespace spricka::report
