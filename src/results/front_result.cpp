// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/front_result.hpp"

#include <cmath>

namespace spricka::results {

namespace {

bool has_best(const KErrorBar& bar) {
  return bar.of_best && std::isfinite(bar.best) && std::isfinite(bar.size());
}

// Faces that do not overlap have no K1 below 0.
double best_of_mode(const FrontPointResult& point, std::size_t mode) {
  const double best = point.bar[mode].best;
  return mode == 0 && point.K1 >= 0.0 ? std::max(0.0, best) : best;
}

void set_K(FrontPointResult& point, const std::array<double, 3>& K) {
  point.K1 = K[0];
  point.K2 = K[1];
  point.K3 = K[2];
}

} // namespace

void take_out_estimated_errors(FrontResult& front) {
  for (FrontPointResult& point : front.points) {
    std::array<double, 3> K = point.K();
    std::array<double, 3> smooth = point.smooth;
    for (std::size_t mode = 0; mode < K.size(); ++mode) {
      if (has_best(point.bar[mode])) {
        smooth[mode] = best_of_mode(point, mode);
        // At the surface K itself is a number of the mesh.
        K[mode] = point.at_surface ? K[mode] : smooth[mode];
      }
    }
    if (smooth != point.smooth || K != point.K()) {
      point.raw = point.K();
      point.raw_smooth = point.smooth;
      set_K(point, K);
      point.smooth = smooth;
    }
  }
}

void put_back_raw_K(FrontPointResult& point) {
  set_K(point, point.raw_K());
  point.smooth = point.raw_smooth_K();
  point.raw.reset();
  point.raw_smooth.reset();
}

} // namespace spricka::results
