// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/path_correction.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace spricka::analysis {

namespace {

// Whether K never turns back between the ends of the path.
bool monotone(const base::PiecewiseLinear& K, double at_end) {
  const double way = at_end - K.at_knot(0);
  double before = K.at_knot(0);
  for (std::size_t k = 0; k <= K.segments() && K.knots()[k] <= 1.0; ++k) {
    if ((K.at_knot(k) - before) * way < 0.0) {
      return false;
    }
    before = K.at_knot(k);
  }
  return way != 0.0 && (at_end - before) * way >= 0.0;
}

double error_of(const results::TipResult& tip, int mode) {
  if (!tip.no_bar.empty() || tip.closed) {
    return 0.0;
  }
  return mode == 1 ? tip.bar[0].best - tip.K1 : tip.bar[1].best - tip.K2;
}

bool touch_on(const base::PiecewiseLinear& K1, std::size_t segment) {
  return K1.at_knot(segment) == 0.0 && K1.slope(segment) == 0.0;
}

} // namespace

bool faces_touch(const base::PiecewiseLinear& K1) {
  for (std::size_t i = 0; i < K1.segments(); ++i) {
    if (touch_on(K1, i)) {
      return true;
    }
  }
  return false;
}

base::PiecewiseLinear correct_K(const base::PiecewiseLinear& K, double at_zero, double at_one) {
  const double K0 = K.at_knot(0);
  const double K1 = K(std::min(1.0, K.knots().back()));
  // An error that changes by more than K does is none of K: beyond the ends it would run away.
  const bool by_K = monotone(K, K1) && std::abs(at_one - at_zero) < std::abs(K1 - K0);
  const double rate = (at_one - at_zero) / (by_K ? K1 - K0 : 1.0);
  std::vector<double> value = K.values();
  std::vector<double> slope = K.slopes();
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (!touch_on(K, i)) {
      value[i] += at_zero + rate * (by_K ? K.at_knot(i) - K0 : K.knots()[i]);
      slope[i] += rate * (by_K ? K.slope(i) : 1.0);
    }
  }
  return {K.knots(), std::move(value), std::move(slope)};
}

double estimated_error(const results::FrontResult& front, std::size_t i) {
  const std::size_t last = front.points.size() - 1;
  const std::size_t near = !front.points[i].at_surface ? i : i == 0 ? 1 : i == last ? last - 1 : i;
  const results::FrontPointResult& place = front.points[near];
  const bool known = results::has_error_bar(front) && !front.points[i].closed && !place.closed;
  return known ? place.bar[0].best - place.K1 : 0.0;
}

results::LoadPathResult corrected_path(results::LoadPathResult path,
                                       const results::StepResult& from,
                                       const results::StepResult& to) {
  for (results::LoadPathTip& tip : path.tips) {
    const results::TipResult* low = results::find_tip(from, tip.name);
    const results::TipResult* high = results::find_tip(to, tip.name);
    if (low != nullptr && high != nullptr) {
      tip.K1 = correct_K(tip.K1, error_of(*low, 1), error_of(*high, 1));
      tip.K2 = correct_K(tip.K2, error_of(*low, 2), error_of(*high, 2));
    }
  }
  for (std::size_t f = 0; f < path.fronts.size(); ++f) {
    for (std::size_t i = 0; i < path.fronts[f].points.size(); ++i) {
      results::LoadPathFrontPoint& point = path.fronts[f].points[i];
      const double low = estimated_error(from.fronts.at(f), i);
      const double high = estimated_error(to.fronts.at(f), i);
      point.K[0] = correct_K(point.K[0], low, high);
      point.smooth[0] = correct_K(point.smooth[0], low, high);
    }
  }
  return path;
}

} // namespace spricka::analysis
