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

using ThreeModes = std::array<double, 3>;

ThreeModes taken_out(const ThreeModes& K, const ThreeModes& raw) {
  return {K[0] - raw[0], K[1] - raw[1], K[2] - raw[2]};
}

void correct_modes(std::array<base::PiecewiseLinear, 3>& K, const ThreeModes& at_zero,
                   const ThreeModes& at_one) {
  for (std::size_t mode = 0; mode < K.size(); ++mode) {
    if (at_zero[mode] != 0.0 || at_one[mode] != 0.0) {
      K[mode] = correct_K(K[mode], at_zero[mode], at_one[mode]);
    }
  }
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

void correct_path_K(const results::LoadStepResult& from, const results::LoadStepResult& to,
                    results::LoadPathResult& path) {
  for (std::size_t f = 0; f < path.fronts.size(); ++f) {
    const results::FrontResult& first = from.fronts.at(f);
    const results::FrontResult& last = to.fronts.at(f);
    for (std::size_t i = 0; i < path.fronts[f].points.size(); ++i) {
      results::LoadPathFrontPoint& point = path.fronts[f].points[i];
      const results::FrontPointResult& low = first.points.at(i);
      const results::FrontPointResult& high = last.points.at(i);
      if (low.raw || high.raw) {
        correct_modes(point.K, taken_out(low.K(), low.raw_K()), taken_out(high.K(), high.raw_K()));
        correct_modes(point.smooth, taken_out(low.smooth, low.raw_smooth_K()),
                      taken_out(high.smooth, high.raw_smooth_K()));
      }
    }
  }
}

} // namespace spricka::analysis
