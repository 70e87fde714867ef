// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/advance_error.hpp"
#include "growth/growth_integrator.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

/// How far the integrator goes at a time.
namespace spricka::growth {

namespace {

/// Steps are logarithms of the ratio by which an arm grows at most.
constexpr double longest_step = 0.7;
constexpr double shortest_step = 0.02; ///< below it only the scatter of meshes is seen
/// Part of the tolerance that is aimed at: errors of intervals add up.
constexpr double aimed_part = 0.4;
constexpr double of_straight_line = 0.15;
/// Turn by which the heading at the end of an advance is missed [rad].
constexpr double aimed_turn_miss = 0.01;
constexpr double largest_turn_miss = 0.05;
/// The place where K reaches the toughness, by two polynomials, agrees to this part of the arms.
constexpr double same_end = 5e-3;
/// An end on the very first advance is believed if that is no longer than this step.
constexpr double first_look = 0.11;

} // namespace

// Judges the last advance and sets the next step.
bool GrowthIntegrator::judge_last_advance() {
  const std::size_t n = state_.stations.size();
  if (n < 2) {
    return true;
  }
  // No polynomial leads over a passage, and there is no shorter one.
  if (passage_) {
    state_.step = passage_policy.step_behind;
    return true;
  }
  const SolvedStation& last = state_.stations[n - 2];
  const SolvedStation& here = state_.stations[n - 1];
  const double asked = state_.step;
  double step = 0.0; // as it came: of an ellipse an axis may go farther than was asked for
  for (std::size_t tip = 0; tip < tips().size(); ++tip) {
    step = std::max(step, std::log1p(advance_[tip] / last.tips[tip].a));
  }
  double factor = 2.0; // of the step
  bool good = true;
  const auto judge = [&](double error, double aim, double limit, double order) {
    if (std::isfinite(error) && error > 0.0) {
      factor = std::min(factor, 0.8 * std::pow(aim / error, 1.0 / order));
      good = good && error <= limit;
    }
  };
  const double tolerance = model_.growth->tolerance;
  // three stations: the error is that of a straight line, a parabola is used
  const double missed =
      interval_cycle_error(state_.stations, law_) * (n > 3 ? 1.0 : of_straight_line);
  judge(missed, aimed_part * tolerance, largest_error_over_tolerance * tolerance,
        n > 3 ? 3.0 : 2.0);
  judge(deferred_cycle_error(here), aimed_part * tolerance,
        largest_error_over_tolerance * tolerance, n > 2 ? 3.0 : 2.0);
  // Behind the first kink of a front headings miss by the root of the advance, however short.
  const double scatter = kinematics_->heading_mesh_scatter();
  if (kinematics_->can_kink() && (scatter == 0.0 || n > 2)) {
    judge(excess_turn_angle(state_.stations, advance_), aimed_turn_miss + scatter,
          largest_turn_miss + scatter, n > 2 ? 2.0 : 1.0);
  }
  const std::optional<GrowthEvent> end = ends().find_crossing(trajectory(), last.s, here.s);
  if (end && n > 2) { // the end is on this interval: is its place sure?
    const GrowthTrajectory other(state_.stations, law_, std::min<std::size_t>(n, 4) - 1);
    const std::optional<GrowthEvent> again = ends().find_crossing(other, last.s, here.s);
    good = good && again && std::abs(again->s - end->s) <= same_end * here.s;
    factor = std::min(factor, std::max(0.3, 1.1 * (end->s - last.s) / (here.s - last.s)));
  } else if (end) {
    good = good && step <= first_look;
    factor = std::min(factor, 0.5);
  }
  if (std::min(step, asked) <= 1.5 * shortest_step) {
    good = true;
  }
  const double next = std::clamp(step * std::clamp(factor, 0.3, 2.0), shortest_step, longest_step);
  state_.step = good ? next : std::max(shortest_step, std::min({next, 0.7 * step, 0.7 * asked}));
  return good;
}

void GrowthIntegrator::shorten_step(const std::string& why) {
  ++state_.rejected;
  if (passage_ && lengthening_ < passage_policy.longest) {
    lengthening_ *= passage_policy.longer;
    return;
  }
  state_.step *= 0.5;
  if (!passage_ && state_.step >= 0.5 * shortest_step && !state_.stations.empty()) {
    return;
  }
  if (std::optional<GrowthEvent> end =
          kinematics_->handle_unmeshable_advance(passage_.has_value(), why)) {
    end_at_station(std::move(*end));
  } else {
    state_.step = shortest_step;
  }
}

} // namespace spricka::growth
