// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/growth_integrator.hpp"
#include "model/crack_growth.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

/// How far the integrator goes at a time, and where it ends.
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
constexpr double aimed_miss = 0.01;
constexpr double largest_miss = 0.05;
/// The place where K reaches the toughness, by two polynomials, agrees to this part of the arms.
constexpr double same_end = 5e-3;
/// Growth of an arm follows from that of the law, at most about so much faster.
constexpr double law_of_length = 3.0;
/// An end on the very first advance is believed if that is no longer than this step.
constexpr double first_look = 0.11;
/// First step behind a breakthrough, and how a breakthrough that cannot be meshed gets longer.
constexpr double step_after_breakthrough = 0.1;
constexpr double longer_breakthrough = 1.15;
constexpr double longest_breakthrough = 3.0;
/// Part of the cycles of a breakthrough that may be wrong.
constexpr double part_of_breakthrough = 0.5;
/// A growth this much slower than it was at its fastest has come to rest.
constexpr double rest = 1e-9;
/// Stations of a growth that gets somewhere: at the shortest step an arm grows by e^20 in as many.
constexpr std::size_t enough_stations = 1000;

// Whether no tip has a K above 0 at the largest load.
bool closed(const SolvedStation& station) {
  return std::ranges::all_of(station.tips,
                             [](const TipStation& tip) { return !(tip.K_max > 0.0); });
}

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
    double curvature = 0.0;
    if (all.size() > 2) {
      const TipStation& before = all[all.size() - 3].tips[tip];
      curvature = last.a > before.a
                      ? std::remainder(last.heading - before.heading, 2.0 * std::numbers::pi) /
                            (last.a - before.a)
                      : 0.0;
    }
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
  kinematics_->damp_deferred(deferred_advance, advance_);
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
  // No polynomial leads over a breakthrough, and there is no shorter one.
  if (leaping_ > 0) {
    state_.step = step_after_breakthrough;
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
  const double tolerance = rules().tolerance;
  // three stations: the error is that of a straight line, a parabola is used
  const double missed = cycles_missed() * (n > 3 ? 1.0 : of_straight_line);
  judge(missed, aimed_part * tolerance, still_good * tolerance, n > 3 ? 3.0 : 2.0);
  judge(drift(), aimed_part * tolerance, still_good * tolerance, n > 2 ? 3.0 : 2.0);
  // Behind the first kink of a front headings miss by the root of the advance, however short.
  const double scatter = kinematics_->kink_scatter();
  if (kinematics_->can_kink() && (scatter == 0.0 || n > 2)) {
    judge(turn_missed(), aimed_miss + scatter, largest_miss + scatter, n > 2 ? 2.0 : 1.0);
  }
  const SolvedStation& last = state_.stations[n - 2];
  const SolvedStation& here = state_.stations[n - 1];
  const std::optional<GrowthEnd> end = crossing(trajectory(), last.s, here.s);
  if (end && n > 2) { // the end is on this interval: is its place sure?
    const GrowthTrajectory other(state_.stations, law_, std::min<std::size_t>(n, 4) - 1);
    const std::optional<GrowthEnd> again = crossing(other, last.s, here.s);
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
  if (leaping_ > 0 && breakthrough_factor_ < longest_breakthrough) {
    breakthrough_factor_ *= longer_breakthrough;
    return;
  }
  state_.step *= 0.5;
  if (leaping_ == 0 && state_.step >= 0.5 * shortest_step && !state_.stations.empty()) {
    return;
  }
  if (const std::optional<GrowthStop> end =
          kinematics_->reject_advance(state_, leaping_ > 0, why)) {
    end_at_station(end->word, end->reason);
  } else {
    state_.step = shortest_step;
  }
}

// The first place between two stations where K reaches the toughness, the ligament its plastic
// limit, or nothing grows any more.
std::optional<GrowthEnd> GrowthIntegrator::crossing(const GrowthTrajectory& between, double s0,
                                                    double s1) const {
  std::optional<GrowthEnd> first;
  const auto consider = [&](std::optional<double> s, const char* word, std::string reason) {
    if (s && (!first || *s < first->s)) {
      first = GrowthEnd{word, std::move(reason), *s};
    }
  };
  const SolvedStation& last = state_.stations.back();
  for (std::size_t tip = 0; tip < tips().size(); ++tip) {
    const TipStation& here = last.tips[tip];
    if (const auto K_c = rules().constants.k_c; K_c && here.K_max >= *K_c) {
      consider(first_crossing([&](double s) { return between.K_max(tip, s) - *K_c; }, s0, s1), "KC",
               fmt::format("K of {} reaches KC", tips()[tip].name));
    }
    if (rules().flow_stress && here.plastic >= 1.0) {
      consider(first_crossing([&](double s) { return between.plastic_load_ratio(tip, s) - 1.0; },
                              s0, s1),
               "NET SECTION",
               fmt::format("the ligament ahead of {} reaches its plastic limit", tips()[tip].name));
    }
  }
  if (!(last.growth_rate() > 0.0)) {
    const bool shut = closed(last);
    consider(
        first_crossing([&](double s) { return between.growth_rate(s) > 0.0 ? -1.0 : 1.0; }, s0, s1),
        shut ? "CLOSED" : "THRESHOLD",
        shut ? "no crack grows any more: none opens at the largest load, K1 is not above 0"
             : "no crack grows any more: delta K has fallen to the threshold");
  }
  return first;
}

// Once a station counts: whether the growth has ended at it or before it.
void GrowthIntegrator::look_for_end() {
  const std::vector<SolvedStation>& all = state_.stations;
  const SolvedStation& here = all.back();
  const double s0 = all.size() > 1 ? all[all.size() - 2].s : here.s;
  const GrowthTrajectory between = trajectory();
  end_.reset();
  if (all.size() == 1) {
    for (std::size_t tip = 0; tip < tips().size(); ++tip) {
      if (rules().constants.k_c && here.tips[tip].K_max >= *rules().constants.k_c) {
        end_at_station("KC", fmt::format("K of {} is KC or more from the start", tips()[tip].name));
      } else if (rules().flow_stress && here.tips[tip].plastic >= 1.0) {
        end_at_station(
            "NET SECTION",
            fmt::format("the ligament ahead of {} is at its plastic limit from the start",
                        tips()[tip].name));
      }
    }
    if (!end_ && !(here.growth_rate() > 0.0)) {
      nothing_grows();
    }
    return;
  }
  end_ = crossing(between, s0, here.s);
  for (std::size_t tip = 0; tip < tips().size() && rules().last_length && !end_; ++tip) {
    if (here.tips[tip].a >= *rules().last_length * (1.0 - 1e-12)) {
      end_at_station("AMAX", fmt::format("{} has its last length, {:.6g}", tips()[tip].name,
                                         *rules().last_length));
    }
  }
  if (rules().cycles) {
    const double last = end_ ? end_->s : here.s;
    const double s_first = all.front().s;
    if (between.cycles(s_first, last) >= *rules().cycles) {
      if (const auto s = between.after_cycles(s_first, *rules().cycles)) {
        end_ = GrowthEnd{"CYCLES", fmt::format("{:.6g} cycles are over", *rules().cycles), *s};
      }
    }
  }
  if (!end_) {
    look_for_no_end();
  }
}

void GrowthIntegrator::nothing_grows() {
  if (closed(state_.stations.back())) {
    end_at_station("CLOSED", "no crack grows: none opens at the largest load, K1 is not above 0");
  } else {
    end_at_station("THRESHOLD", "no crack grows: delta K is not above the threshold");
  }
}

// All that a tip has turned by since the first station [rad], left positive.
double GrowthIntegrator::turned(std::size_t tip) const {
  double sum = 0.0;
  for (std::size_t i = 1; i < state_.stations.size(); ++i) {
    sum += std::remainder(state_.stations[i].tips[tip].heading -
                              state_.stations[i - 1].tips[tip].heading,
                          2.0 * std::numbers::pi);
  }
  return sum;
}

// More where DA is so small that the way across the body takes them.
std::size_t GrowthIntegrator::most_stations() const {
  if (!rules().largest_advance) {
    return enough_stations;
  }
  base::Vec3 low = base::Vec3::Constant(std::numeric_limits<double>::infinity());
  base::Vec3 high = -low;
  for (const base::Vec3& x : model_.mesh.x) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  const double kinematics = 2.0 * (high - low).norm() / *rules().largest_advance;
  return enough_stations + static_cast<std::size_t>(std::min(kinematics, 1e6));
}

// Growth that goes on and leads nowhere.
void GrowthIntegrator::look_for_no_end() {
  const std::vector<SolvedStation>& all = state_.stations;
  double fastest = 0.0;
  for (const SolvedStation& station : all) {
    fastest = std::max(fastest, station.growth_rate());
  }
  if (std::isfinite(fastest) && all.back().growth_rate() < rest * fastest) {
    end_at_station("ARREST", fmt::format("the growth has come to rest: it is {:.1e} of the fastest",
                                         all.back().growth_rate() / fastest));
  }
  for (std::size_t tip = 0; tip < tips().size() && !end_; ++tip) {
    if (std::abs(turned(tip)) > 2.0 * std::numbers::pi) {
      end_at_station("CURL", fmt::format("{} has turned by a full circle", tips()[tip].name));
    }
  }
  if (!end_ && all.size() >= most_stations()) {
    end_at_station("STATIONS",
                   fmt::format("the growth has not ended after {} stations", all.size()));
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
      missed += part_of_breakthrough * fine.cycles(all[i].s, to);
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
