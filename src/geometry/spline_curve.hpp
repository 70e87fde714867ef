// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "geometry/cubic_spline.hpp"

namespace spricka::geometry {

/// A place of a curve by its arc length, with derivatives by the parameter of its spline.
struct SplineCurvePoint {
  SplinePosition position; ///< on the spline; of a place beyond an end that end
  double beyond = 0.0;     ///< length behind the last end, negative before the first one
  base::Vec3 x = base::Vec3::Zero();
  base::Vec3 first = base::Vec3::UnitX();
  base::Vec3 second = base::Vec3::Zero();
};

/// A smooth curve through points in space by its arc length s from the first one: a cubic spline
/// over the chord length. An open one has ends not-a-knot and goes straight on beyond them; of a
/// closed one s counts on over its end.
class SplineCurve {
public:
  /// points [>= 2; >= 4 if closed, the first not repeated], no two in a row at one place. The
  /// length of each interval is the sum over `parts` of a Gauss rule of degree 9: by one, 1e-10 of
  /// it where it turns by a quarter.
  SplineCurve(std::vector<base::Vec3> points, bool closed, int parts = 1);

  [[nodiscard]] double length() const { return arc_.back(); }
  [[nodiscard]] bool closed() const { return closed_; }
  /// Place, derivatives and interval at arc length s [length]; beyond an open end on its tangent.
  [[nodiscard]] SplineCurvePoint point(double s) const;
  /// The place alone at arc length s [length].
  [[nodiscard]] base::Vec3 at(double s) const { return point(s).x; }
  /// Unit tangent of the curve at arc length s [length], towards larger s.
  [[nodiscard]] base::Vec3 tangent(double s) const { return point(s).first.normalized(); }
  [[nodiscard]] double curvature(double s) const; ///< [1/length] magnitude; 0 beyond an end
  /// The length at which the curve is nearest to x; below 0 or above length() beyond an open end.
  [[nodiscard]] double nearest_length(const base::Vec3& x) const;
  /// Its knots [point; of a closed one the first again] are sums of chords.
  [[nodiscard]] const CubicSpline<base::Vec3>& spline() const { return spline_; }

private:
  [[nodiscard]] double length_to(const SplinePosition& at) const; ///< from the interval's start
  [[nodiscard]] SplinePosition locate(double s) const;
  [[nodiscard]] SplinePosition nearest_on(std::size_t interval, const base::Vec3& x) const;

  bool closed_;
  int parts_;
  CubicSpline<base::Vec3> spline_;
  std::vector<double> arc_; ///< [knot] length of the curve up to there
};

} // namespace spricka::geometry
