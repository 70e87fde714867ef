// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/growth_point_names.hpp"

#include "report/topics/front_places.hpp"
#include "report/topics/growth_tables.hpp"

#include <fmt/format.h>

namespace spricka::report {

std::vector<ReportedGrowthPoint> name_reported_growth_points(const results::RunResult& run) {
  const results::GrowthResult& growth = *run.growth;
  const std::vector<std::size_t> reported = reported_growth_points(growth);
  const bool some_are_left_out = reported.size() < growth.point_names.size();
  std::vector<ReportedGrowthPoint> points;
  for (const std::size_t i : reported) {
    std::string name = growth.point_names[i];
    const std::string face =
        some_are_left_out
            ? FaceNames(run.increments.front().mesh).at(growth.stations.front().points[i].x)
            : std::string();
    points.push_back({i, face.empty() ? name : fmt::format("{} at {}", name, face)});
  }
  return points;
}

} // namespace spricka::report
