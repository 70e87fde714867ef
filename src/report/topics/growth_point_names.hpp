// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/results.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace spricka::report {

/// A point whose growth is drawn, with the face that it lies on in its name.
struct ReportedGrowthPoint {
  std::size_t index = 0; ///< of GrowthResult::point_names
  std::string name;
};

/// Those that figures of a growth show. The run has a growth.
std::vector<ReportedGrowthPoint> name_reported_growth_points(const results::RunResult& run);

} // namespace spricka::report
