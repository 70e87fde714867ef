// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <vector>

namespace spricka::growth {

/// A smooth curve through points in the plane: a cubic spline over the chord length with not-a-knot
/// ends (de Boor 1978, chapter IV), a parabola through three points, straight on beyond both ends
/// along its tangents there.
class SmoothCurve {
public:
  /// points [>= 2], no two in a row at one place.
  explicit SmoothCurve(std::vector<base::Vec3> points);

  [[nodiscard]] double length() const { return arc_.back(); }
  [[nodiscard]] base::Vec3 at(double s) const;      ///< s: arc length from the first point
  [[nodiscard]] base::Vec3 tangent(double s) const; ///< unit
  [[nodiscard]] double curvature(double s) const;   ///< [1/length] magnitude; 0 beyond the ends

private:
  struct CurvePosition {
    std::size_t interval;
    double t; ///< from the interval's first knot
  };
  [[nodiscard]] CurvePosition find(double s) const;
  [[nodiscard]] base::Vec3 derivative(const CurvePosition& p) const;
  [[nodiscard]] double speed_integral(std::size_t interval, double t) const;

  std::vector<base::Vec3> points_;
  std::vector<base::Vec3> moment_; ///< [point] second derivative
  std::vector<double> knot_;       ///< [point] chord length
  std::vector<double> arc_;        ///< [point] arc length
};

/// The stretch of a curve from s0 to s1 as a polyline whose kinks are small: a twentieth of a
/// radian inside, and at its tips (the end, the beginning too if `two_tips`) a straight piece along
/// the tangent over which the curve turns by a fiftieth.
std::vector<base::Vec3> as_polyline(const SmoothCurve& curve, double s0, double s1, bool two_tips);

} // namespace spricka::growth
