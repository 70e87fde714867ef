// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "geometry/spline_curve.hpp"

#include <vector>

namespace spricka::growth {

/// Angle [rad] that a way may turn by over one piece of the polyline that stands for it.
inline constexpr double turn_of_chord = 0.05;

/// The stretch of a curve from s0 to s1 as a polyline whose kinks are small: a twentieth of a
/// radian inside, and at its tips (the end, the beginning too if `two_tips`) a straight piece along
/// the tangent over which the curve turns by a fiftieth.
std::vector<base::Vec3> polyline_of_curve(const geometry::SplineCurve& curve, double s0, double s1,
                                          bool two_tips);

} // namespace spricka::growth
