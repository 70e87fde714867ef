// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

namespace spricka::life {

/// A smoothed curve at the points it was made from.
struct SmoothedCurve {
  std::vector<double> value, slope;
  std::vector<double> slope_error; ///< standard deviation of the slope
  double deviation = 0.0;          ///< standard deviation of the weighted points about the curve
  double freedoms = 0.0;           ///< trace of the influence matrix
};

/// Cubic smoothing spline of y(x), x [>= 8] ascending: least sum of (weight (y - f))^2 plus lambda
/// times the integral of f''^2, in cubic B-splines of fifty intervals at most, two points or more
/// in each. lambda by generalised cross-validation (Craven, Wahba 1979), each freedom counted 1.4
/// times, which keeps it from following scatter (Kim, Gu 2004); errors by Wahba 1983. (life.19)
SmoothedCurve fit_smoothing_spline(const std::vector<double>& x, const std::vector<double>& y,
                                   const std::vector<double>& weight);

/// What 95 % of Student's t lie within, for that many degrees of freedom > 0.
double two_sided_student_quantile_95(double freedoms);

} // namespace spricka::life
