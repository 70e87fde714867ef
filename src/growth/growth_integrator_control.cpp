// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/growth_integrator.hpp"
#include "model/crack_growth.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

/// How far the integrator goes at a time.
namespace spricka::growth {

namespace {

/// Steps are logarithms of the ratio by which an arm grows at most.
constexpr double longest_step = 0.7;
constexpr double shortest_step = 0.02; ///< below it only the scatter of meshes is seen
/// Solutions whose error is more times the tolerance than this do not count. The error is that of
/// a polynomial one order below the one that is used.
constexpr double still_good = 1.5;
/// Part of the tolerance that is aimed at: errors of intervals add up.
constexpr double aimed_part = 0.4;
constexpr double of_straight_line = 0.15;
/// Cycles that are few against those so far need no better than this part of the tolerance's due.
constexpr double small_part = 0.1;
/// Turn by which the heading at the end of an advance is missed [rad].
constexpr double aimed_turn_miss = 0.01;
constexpr double largest_turn_miss = 0.05;
/// The place where K reaches the toughness, by two polynomials, agrees to this part of the arms.
constexpr double same_end = 5e-3;
/// Growth of an arm follows from that of the law, at most about so much faster.
constexpr double law_of_length = 3.0;
/// An end on the very first advance is believed if that is no longer than this step.
constexpr double first_look = 0.11;

} // namespace

// Of the last interval, as a part of the cycles that count there; not a number with two stations.
double GrowthIntegrator::cycles_missed() const {
  const std::vector<SolvedStation>& all = state_.stations;
  const std::size_t n = all.size();
  if (n < 3) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double s0 = all[n - 2].s;
  const double s1 = all[n - 1].s;
  const std::size_t points = std::min<std::size_t>(n, 4);
  const double fine = GrowthTrajectory(all, law_, points).cycles(s0, s1);
  const double coarse = GrowthTrajectory(all, law_, points - 1).cycles(s0, s1);
  const double before = GrowthTrajectory(all, law_, 4).cycles(all.front().s, s0);
  return std::abs(fine - coarse) / std::max(fine, small_part * before);
}

// What the heading turned more than the advance was bent for; not a number at the first.
double GrowthIntegrator::turn_missed() const {
  const std::vector<SolvedStation>& all = state_.stations;
  double most = 0.0;
  for (std::size_t tip = 0; all.size() > 1 && tip < tips().size(); ++tip) {
    if (advance_[tip] <= 0.0) {
      continue;
    }
    const TipStation& here = all.back().tips[tip];
    const TipStation& last = all[all.size() - 2].tips[tip];
    const double curvature =
        all.size() > 2 ? tip_path_curvature(all[all.size() - 3].tips[tip], last) : 0.0;
    const double expected = last.heading + curvature * advance_[tip];
    most =
        std::max(most, std::abs(std::remainder(here.heading - expected, 2.0 * std::numbers::pi)));
  }
  return most;
}

// What the rates, the new ones too, make of the last advance: the integral of the shares by the
// parabola through three stations, or by the trapezoidal rule. The next advance makes up for it.
void GrowthIntegrator::settle() {
  std::vector<SolvedStation>& all = state_.stations;
  const std::size_t n = all.size();
  if (n < 2 || tips().size() < 2 || !(all.back().growth_rate() > 0.0) ||
      !std::isfinite(all.back().growth_rate())) {
    return;
  }
  if (all.back().breakthroughs > 0) {
    return; // shares before and behind have nothing in common
  }
  std::vector<double> deferred_advance;
  for (const TipStation& tip : all[n - 2].tips) {
    deferred_advance.push_back(tip.deferred_advance);
  }
  kinematics_->damp_deferred_advance(deferred_advance, advance_);
  const double h = all[n - 1].s - all[n - 2].s;
  for (std::size_t tip = 0; tip < tips().size(); ++tip) {
    const auto share = [&](std::size_t k) { return all[k].tips[tip].rate / all[k].growth_rate(); };
    double made = 0.5 * h * (share(n - 2) + share(n - 1));
    if (n > 2 && all[n - 2].breakthroughs == 0) {
      const double before = all[n - 2].s - all[n - 3].s;
      const double bend =
          ((share(n - 1) - share(n - 2)) / h - (share(n - 2) - share(n - 3)) / before) /
          (h + before);
      made -= h * h * h / 6.0 * bend;
    }
    all[n - 1].tips[tip].deferred_advance = deferred_advance[tip] + made - advance_[tip];
  }
}

// The deferred advance after the last advance, as a part of the cycles.
double GrowthIntegrator::drift() const {
  const SolvedStation& here = state_.stations.back();
  double most = 0.0;
  for (const TipStation& tip : here.tips) {
    most = std::max(most, law_of_length * std::abs(tip.deferred_advance) / tip.a);
  }
  return most;
}

// Judges the last advance and sets the next step.
bool GrowthIntegrator::good_enough() {
  const std::size_t n = state_.stations.size();
  if (n < 2) {
    return true;
  }
  // No polynomial leads over a passage, and there is no shorter one.
  if (passage_) {
    state_.step = passage_policy.step_behind;
    return true;
  }
  const double asked = state_.step;
  double step = 0.0; // as it came: of an ellipse an axis may go farther than was asked for
  for (std::size_t tip = 0; tip < tips().size(); ++tip) {
    step = std::max(step, std::log1p(advance_[tip] / state_.stations[n - 2].tips[tip].a));
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
  const double missed = cycles_missed() * (n > 3 ? 1.0 : of_straight_line);
  judge(missed, aimed_part * tolerance, still_good * tolerance, n > 3 ? 3.0 : 2.0);
  judge(drift(), aimed_part * tolerance, still_good * tolerance, n > 2 ? 3.0 : 2.0);
  // Behind the first kink of a front headings miss by the root of the advance, however short.
  const double scatter = kinematics_->heading_scatter();
  if (kinematics_->can_kink() && (scatter == 0.0 || n > 2)) {
    judge(turn_missed(), aimed_turn_miss + scatter, largest_turn_miss + scatter, n > 2 ? 2.0 : 1.0);
  }
  const SolvedStation& last = state_.stations[n - 2];
  const SolvedStation& here = state_.stations[n - 1];
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
  if (std::optional<GrowthEvent> end = kinematics_->reject_advance(passage_.has_value(), why)) {
    end_at_station(std::move(*end));
  } else {
    state_.step = shortest_step;
  }
}

double GrowthIntegrator::cycle_error() const {
  const std::vector<SolvedStation>& all = state_.stations;
  const std::size_t points = std::min<std::size_t>(all.size(), 4);
  if (points < 3) {
    return all.size() == 1 ? 0.0 : std::numeric_limits<double>::quiet_NaN();
  }
  const GrowthTrajectory fine(all, law_, points);
  const GrowthTrajectory coarse(all, law_, points - 1);
  const double last = end_ ? end_->s : all.back().s;
  double missed = 0.0;
  for (std::size_t i = 0; i + 1 < all.size() && all[i].s < last; ++i) {
    const double to = std::min(all[i + 1].s, last);
    if (all[i + 1].breakthroughs > 0) { // K is known at both ends of it only
      missed += passage_policy.uncertain_cycles * fine.cycles(all[i].s, to);
      continue;
    }
    double uncertain_fraction = 0.0; // a front that is not where it should be
    for (const TipStation& tip : all[i + 1].tips) {
      uncertain_fraction = std::max(uncertain_fraction, tip.uncertain_fraction);
    }
    const double cycles = fine.cycles(all[i].s, to);
    missed += std::abs(cycles - coarse.cycles(all[i].s, to)) + uncertain_fraction * cycles;
  }
  return missed / fine.cycles(all.front().s, last);
}

} // namespace spricka::growth
