// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "report/drawing/table.hpp"
#include "results/load_total.hpp"

#include <string>
#include <vector>

namespace spricka::report {

/// Units and form of a model, as far as totals of loads need them.
struct LoadTableUnits {
  std::string length_unit, force_unit;
  int dim = 2;
};

/// Total force and moment of each load case with factor 1.
ReportTable load_table(const std::vector<results::LoadTotal>& loads, const LoadTableUnits& form);

} // namespace spricka::report
