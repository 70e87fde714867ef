// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "report/table.hpp"
#include "results/results.hpp"

namespace spricka::report {

/// The solutions on the way to K within its tolerance; without rows where no $TIPNET has TOL.
Table rounds_table(const results::Run& run);

} // namespace spricka::report
