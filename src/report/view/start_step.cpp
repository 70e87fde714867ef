// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/view/start_step.hpp"

#include <algorithm>
#include <utility>

namespace spricka::report {
namespace {

/// Largest K1 of a step, and its strain energy where no K tells.
std::pair<double, double> severity_of(const results::LoadStepResult& step) {
  double largest = 0.0;
  for (const results::FrontResult& front : step.fronts) {
    for (const results::FrontPointResult& point : front.points) {
      largest = point.at_surface && !front.is_tip() ? largest : std::max(largest, point.K1);
    }
  }
  return {largest, step.energy};
}

} // namespace

std::size_t find_start_step(const results::CrackLengthResult& increment) {
  const auto worst = std::ranges::max_element(increment.steps, {}, severity_of);
  return static_cast<std::size_t>(worst - increment.steps.begin());
}

} // namespace spricka::report
