// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/smooth_line.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::growth {

using base::Vec3;

namespace {

/// Angle [rad] that the curve may turn by over the piece at a tip: K follows the direction at the
/// tip to first order, kinks farther away (turn_of_chord) to second order.
constexpr double turn_at_tip = 0.02;
/// The straight piece at a tip as a part of the crack's length, at most.
constexpr double tip_part = 0.25;

} // namespace

std::vector<Vec3> polyline_of_curve(const geometry::SplineCurve& curve, double s0, double s1,
                                    bool two_tips) {
  // A piece over which the curve turns by turn_at_tip, no longer than `most`; the inner maximum
  // keeps a straight end from a division by zero.
  const double most = tip_part * (s1 - s0);
  const auto tip_piece = [&](double s) {
    return std::min(most, turn_at_tip / std::max(curve.curvature(s), turn_at_tip / most));
  };
  const double first = two_tips ? s0 + tip_piece(s0) : s0;
  const double last = s1 - tip_piece(s1);
  std::vector<Vec3> points{curve.at(s0)};
  if (two_tips) {
    points.emplace_back(curve.at(s0) + (first - s0) * curve.tangent(s0));
  }
  // as many pieces as it takes for the sharpest bend, equally long
  constexpr int looks = 200;
  double sharpest = 0.0;
  for (int k = 0; k <= looks; ++k) {
    sharpest = std::max(sharpest, curve.curvature(first + (last - first) * k / looks));
  }
  const int pieces =
      std::max(1, static_cast<int>(std::ceil(sharpest * (last - first) / turn_of_chord)));
  for (int k = 1; k < pieces; ++k) {
    points.push_back(curve.at(first + (last - first) * k / pieces));
  }
  points.emplace_back(curve.at(s1) - (s1 - last) * curve.tangent(s1));
  points.push_back(curve.at(s1));
  return points;
}

} // namespace spricka::growth
