// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

namespace spricka::life {

/// Cubic spline with not-a-knot ends (de Boor 1978, chapter IV); a parabola through three points,
/// a straight line through two. Outside its points its first and last cubics go on.
class CubicSpline {
public:
  /// x [>= 2] ascending, y [x].
  CubicSpline(std::vector<double> x, std::vector<double> y);

  [[nodiscard]] double operator()(double x) const;
  [[nodiscard]] const std::vector<double>& knots() const { return x_; }

private:
  std::vector<double> x_, y_;
  std::vector<double> bend_; ///< [x] second derivative
};

} // namespace spricka::life
