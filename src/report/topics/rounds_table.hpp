// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "report/drawing/table.hpp"
#include "results/results.hpp"

namespace spricka::report {

/// The solutions on the way to K within its tolerance; without rows where no $TIPNET has TOL.
/// `times`: with the CPU time of each, which is another in every run.
ReportTable tolerance_rounds_table(const results::RunResult& run, bool times);

} // namespace spricka::report
