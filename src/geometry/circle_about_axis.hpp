// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <span>

namespace spricka::geometry {

/// A circle about an axis.
struct CircleAboutAxis {
  base::Vec3 centre = base::Vec3::Zero(); ///< at the mean height of the points along the axis
  base::Vec3 axis = base::Vec3::UnitZ();  ///< unit, its largest component positive
  double radius = 0.0;
  double misfit = 0.0; ///< largest distance of a point from the circle's cylinder, in radii

  /// The point at an angle [rad] and a height above the centre. Angles count by the right hand
  /// about the axis, from x, or where the axis is nearest to x from y, to y from z.
  [[nodiscard]] base::Vec3 point(double angle, double height) const;
  [[nodiscard]] double angle_of(const base::Vec3& point) const; ///< -pi .. pi
  [[nodiscard]] double height_of(const base::Vec3& point) const;

private:
  [[nodiscard]] base::Vec3 zero_direction() const;
};

/// The circle of least squares (fit_circle) of points seen along an axis, three at least that lie
/// on no line; of others the radius is 0 or far beyond them.
CircleAboutAxis fit_circle_about_axis(std::span<const base::Vec3> points, const base::Vec3& axis);

/// The direction in which unit or weighted vectors spread least, and how much: the eigenvector and
/// the square root of the smallest eigenvalue over the largest of their second moments about 0.
struct LeastSpread {
  base::Vec3 direction = base::Vec3::UnitZ();
  double smallest = 0.0; ///< ratios to the largest
  double middle = 0.0;
};
LeastSpread least_spread(std::span<const base::Vec3> vectors);

} // namespace spricka::geometry
