// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/growth_events.hpp"

#include <algorithm>
#include <array>

namespace spricka::growth {

const char* GrowthEvent::word() const {
  // In the order of the kinds; passages have none.
  static constexpr std::array words{"",       "",       "EDGE", "LINK-UP",     "PATH END",
                                    "AMAX",   "CYCLES", "KC",   "NET SECTION", "THRESHOLD",
                                    "CLOSED", "ARREST", "CURL", "MESH",        "STATIONS"};
  static_assert(words.size() == static_cast<std::size_t>(GrowthEventKind::endless) + 1);
  return words.at(static_cast<std::size_t>(kind));
}

void limit_advance_by_obstacle(const ObstaclePolicy& policy, const ObstacleAhead& ahead,
                               double share, bool early, AdvanceLimit& limit) {
  limit.ds = std::min(limit.ds, policy.step * ahead.distance / share);
  if (ahead.part < (early ? policy.passed_early : policy.passed) && ahead.goes_on &&
      ahead.goes_on()) {
    limit.event = GrowthEvent{.kind = policy.passage,
                              .advance = policy.own_way * ahead.distance / share,
                              .crack = ahead.crack};
  } else if (ahead.part < policy.end_gap) {
    limit.event = GrowthEvent{.kind = policy.end, .reason = ahead.reason};
  }
}

} // namespace spricka::growth
