// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/path_correction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace spricka::analysis {

namespace {

// Whether K never turns back between the ends of the path.
bool monotone(const base::PiecewiseLinear& K, double at_end) {
  const double way = at_end - K.value_at_knot(0);
  double before = K.value_at_knot(0);
  for (std::size_t k = 0; k <= K.segment_count() && K.knots()[k] <= 1.0; ++k) {
    if ((K.value_at_knot(k) - before) * way < 0.0) {
      return false;
    }
    before = K.value_at_knot(k);
  }
  return way != 0.0 && (at_end - before) * way >= 0.0;
}

bool touch_on(const base::PiecewiseLinear& K1, std::size_t segment) {
  return K1.value_at_knot(segment) == 0.0 && K1.slope(segment) == 0.0;
}

} // namespace

bool faces_touch_on_path(const base::PiecewiseLinear& K1) {
  for (std::size_t i = 0; i < K1.segment_count(); ++i) {
    if (touch_on(K1, i)) {
      return true;
    }
  }
  return false;
}

base::PiecewiseLinear correct_K(const base::PiecewiseLinear& K, double at_zero, double at_one) {
  const double K0 = K.value_at_knot(0);
  const double K1 = K(std::min(1.0, K.knots().back()));
  // An error that changes by more than K does is none of K: beyond the ends it would run away.
  const bool by_K = monotone(K, K1) && std::abs(at_one - at_zero) < std::abs(K1 - K0);
  const double rate = (at_one - at_zero) / (by_K ? K1 - K0 : 1.0);
  std::vector<double> value = K.segment_start_values();
  std::vector<double> slope = K.segment_slopes();
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (!touch_on(K, i)) {
      value[i] += at_zero + rate * (by_K ? K.value_at_knot(i) - K0 : K.knots()[i]);
      slope[i] += rate * (by_K ? K.slope(i) : 1.0);
    }
  }
  return {K.knots(), std::move(value), std::move(slope)};
}

double estimated_K_error(const results::FrontResult& front, std::size_t i, std::size_t mode) {
  const std::size_t last = front.points.size() - 1;
  const std::size_t near = !front.points[i].at_surface ? i : i == 0 ? 1 : i == last ? last - 1 : i;
  const results::FrontPointResult& point = front.points[near];
  const bool known = front.has_error_bar() && !front.points[i].closed && !point.closed;
  const std::array<double, 3> K{point.K1, point.K2, point.K3};
  return known ? point.bar[mode].best - K[mode] : 0.0;
}

results::LoadPathResult correct_path_K(results::LoadPathResult path,
                                       const results::LoadStepResult& from,
                                       const results::LoadStepResult& to) {
  for (std::size_t f = 0; f < path.fronts.size(); ++f) {
    const std::size_t modes = from.fronts.at(f).is_tip() ? 2 : 1;
    for (std::size_t i = 0; i < path.fronts[f].points.size(); ++i) {
      results::LoadPathFrontPoint& point = path.fronts[f].points[i];
      for (std::size_t mode = 0; mode < modes; ++mode) {
        const double low = estimated_K_error(from.fronts.at(f), i, mode);
        const double high = estimated_K_error(to.fronts.at(f), i, mode);
        point.K[mode] = correct_K(point.K[mode], low, high);
        point.smooth[mode] = correct_K(point.smooth[mode], low, high);
      }
    }
  }
  return path;
}

} // namespace spricka::analysis
