// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/advance_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace spricka::growth {

namespace {

/// Cycles that are few against those so far need no better than this part of the tolerance's due.
constexpr double small_part = 0.1;
/// Growth of an arm follows from that of the law, at most about so much faster.
constexpr double law_of_length = 3.0;

} // namespace

double interval_cycle_error(const std::vector<SolvedStation>& all, const GrowthRateFunction& law) {
  const std::size_t n = all.size();
  if (n < 3) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double s0 = all[n - 2].s;
  const double s1 = all[n - 1].s;
  const std::size_t points = std::min<std::size_t>(n, 4);
  const double fine = GrowthTrajectory(all, law, points).cycles(s0, s1);
  const double coarse = GrowthTrajectory(all, law, points - 1).cycles(s0, s1);
  const double before = GrowthTrajectory(all, law, 4).cycles(all.front().s, s0);
  return std::abs(fine - coarse) / std::max(fine, small_part * before);
}

double excess_turn_angle(const std::vector<SolvedStation>& all,
                         const std::vector<double>& advance) {
  double most = 0.0;
  for (std::size_t tip = 0; all.size() > 1 && tip < advance.size(); ++tip) {
    if (advance[tip] <= 0.0) {
      continue;
    }
    const TipStation& here = all.back().tips[tip];
    const TipStation& last = all[all.size() - 2].tips[tip];
    const double curvature =
        all.size() > 2 ? tip_path_curvature(all[all.size() - 3].tips[tip], last) : 0.0;
    const double expected = last.heading + curvature * advance[tip];
    most =
        std::max(most, std::abs(std::remainder(here.heading - expected, 2.0 * std::numbers::pi)));
  }
  return most;
}

double deferred_cycle_error(const SolvedStation& here) {
  double most = 0.0;
  for (const TipStation& tip : here.tips) {
    most = std::max(most, law_of_length * std::abs(tip.deferred_advance) / tip.a);
  }
  return most;
}

void defer_advance_correction(const CrackKinematics& kinematics, const std::vector<double>& advance,
                              std::vector<SolvedStation>& all) {
  const std::size_t n = all.size();
  if (n < 2 || advance.size() < 2 || !(all.back().growth_rate() > 0.0) ||
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
  kinematics.damp_deferred_advance(deferred_advance, advance);
  const double h = all[n - 1].s - all[n - 2].s;
  for (std::size_t tip = 0; tip < advance.size(); ++tip) {
    const auto share = [&](std::size_t k) { return all[k].tips[tip].rate / all[k].growth_rate(); };
    double made = 0.5 * h * (share(n - 2) + share(n - 1));
    if (n > 2 && all[n - 2].breakthroughs == 0) {
      const double before = all[n - 2].s - all[n - 3].s;
      const double bend =
          ((share(n - 1) - share(n - 2)) / h - (share(n - 2) - share(n - 3)) / before) /
          (h + before);
      made -= h * h * h / 6.0 * bend;
    }
    all[n - 1].tips[tip].deferred_advance = deferred_advance[tip] + made - advance[tip];
  }
}

double total_cycle_error(const std::vector<SolvedStation>& all, const GrowthRateFunction& law,
                         const std::optional<GrowthEvent>& end) {
  const std::size_t points = std::min<std::size_t>(all.size(), 4);
  if (points < 3) {
    return all.size() == 1 ? 0.0 : std::numeric_limits<double>::quiet_NaN();
  }
  const GrowthTrajectory fine(all, law, points);
  const GrowthTrajectory coarse(all, law, points - 1);
  const double last = end ? end->s : all.back().s;
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
