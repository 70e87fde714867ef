// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/growth_region.hpp"

#include "analysis/lengths/log_writer.hpp"
#include "geometry/polyline.hpp"
#include "growth/crack_lines.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

/// Lengths that are looked at, and how many times its length a crack is foreseen at most.
constexpr int looks = 10;
constexpr double farthest = 8.0;

} // namespace

RecondensedGrowthRegion::RecondensedGrowthRegion(const model::Model& model) : model_(model) {
  plan_.follows_patches = std::ranges::none_of(model.cracks, &model::CrackDefinition::is_line);
  plan_.split = plan_.follows_patches;
}

// Along the way ahead as it is known now: straight on from every tip, to AMAX or the next edge.
void RecondensedGrowthRegion::choose(const std::vector<mesh::CrackLine>& lines,
                                     const growth::GrowthIntegrator& integrator) {
  plan_ = {};
  add_to_crack_region(model_, lines, plan_);
  double longest = 0.0;
  for (const mesh::CrackLine& line : lines) {
    longest = std::max(longest, geometry::polyline_length(line.points));
  }
  // Without AMAX to some lengths of the longest crack; what lies beyond is a new region's matter.
  const double reach = model_.growth->last_length.value_or((farthest - 1.0) * longest);
  for (int k = 1; k <= looks; ++k) {
    const double part = static_cast<double>(k) / looks;
    // Closer together near the tips, where the next stations will be.
    add_to_crack_region(model_, integrator.extend_cracks_straight(reach * part * part).lines,
                        plan_);
  }
}

void RecondensedGrowthRegion::update_region(const std::vector<mesh::CrackLine>& lines,
                                            const growth::GrowthIntegrator& integrator,
                                            std::vector<results::LogLine>& log) {
  CrackRegionPlan here;
  add_to_crack_region(model_, lines, here);
  // A region that holds all that this length touches stays, so that the rest is not condensed
  // again.
  if (plan_.covers(here.region)) {
    return;
  }
  const bool first = plan_.region.empty();
  choose(lines, integrator);
  renewed_ = !first;
  log_choice(first, log);
}

void RecondensedGrowthRegion::log_choice(bool first, std::vector<results::LogLine>& log) const {
  LogWriter(log).add_line(
      "GROW", fmt::format("{}: {} of {} elements are condensed at every station",
                          first ? "region chosen" : "a crack leaves its region, a new one",
                          std::ranges::count(plan_.region, true), plan_.region.size()));
}

void RecondensedGrowthRegion::log_region_cost(bool divided, std::vector<results::LogLine>& log) {
  const auto last = std::find_if(log.rbegin(), log.rend(), [](const results::LogLine& line) {
    return line.processor == "CONDENSE";
  });
  if (last == log.rend() || !divided) {
    return;
  }
  const double cpu = last->cpu;
  if (plan_.follows_patches && plan_.region != before_) {
    renewed_ = !before_.empty();
    log_choice(before_.empty(), log);
    before_ = plan_.region;
  }
  if (renewed_) {
    LogWriter(log).add_line("GROW",
                            fmt::format("the new region cost {:.2f} s: the rest was condensed "
                                        "again ({:.2f} s, {:.2f} s at a usual station)",
                                        std::max(0.0, cpu - usual_), cpu, usual_));
  } else {
    usual_ = cpu;
  }
  renewed_ = false;
}

void RecondensedGrowthRegion::save_state(results::NamedArrays& arrays) const {
  arrays.integers["region"] = {plan_.region.begin(), plan_.region.end()};
  arrays.integers["region.split"] = {plan_.split ? 1 : 0};
}

void RecondensedGrowthRegion::restore_state(const results::NamedArrays& arrays) {
  const auto region = arrays.integers.find("region");
  if (region == arrays.integers.end()) {
    return;
  }
  if (!region->second.empty() && region->second.size() != model_.mesh.element_count()) {
    throw base::CorruptStoredField("region", "a region of another mesh");
  }
  plan_.region.assign(region->second.begin(), region->second.end());
  before_ = plan_.region;
  plan_.split = results::required_array(arrays.integers, "region.split", 1)[0] != 0;
}

} // namespace spricka::analysis
