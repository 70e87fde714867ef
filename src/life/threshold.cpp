// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/threshold.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::life {

FatigueThreshold::FatigueThreshold(const model::GrowthLawConstants& constants)
    : constant_(constants.threshold), over_ratio_(constants.threshold_over_ratio),
      closure_(constants.alpha, constants.stress_ratio) {
  if (over_ratio_) {
    // (life.25) at R = 0, solved for the other constant.
    at_full_ratio_ =
        over_ratio_->delta_k * (over_ratio_->at_zero_ratio
                                    ? std::pow(1.0 - closure_(0.0), 1.0 + over_ratio_->slope_above)
                                    : 1.0);
  }
}

double FatigueThreshold::operator()(double R, double a) const {
  if (!over_ratio_) {
    return constant_;
  }
  constexpr double lowest_ratio = -2.0; // the opening function ends there
  R = std::clamp(R, lowest_ratio, over_ratio_->largest_ratio);
  const double open_at_zero = 1.0 - closure_(0.0);
  const double slope = R >= 0.0 ? over_ratio_->slope_above : over_ratio_->slope_below;
  const double level = over_ratio_->slope_above - R * slope;
  const double long_crack = at_full_ratio_ *
                            std::pow((1.0 - R) / (1.0 - closure_(R)), 1.0 + R * slope) /
                            std::pow(open_at_zero, level);
  const double short_part = over_ratio_->intrinsic_length / a; // 0 of a long one
  return long_crack / std::sqrt(1.0 + short_part);
}

} // namespace spricka::life
