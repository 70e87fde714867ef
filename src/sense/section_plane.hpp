// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

namespace spricka::sense {

/// Where a solid is cut, and where its places lie in the section.
struct SectionPlane {
  bool round = false; ///< about the axis, which runs through the origin; else along it
  int axis = 2;
  double first = 0.0; ///< the section lies there: coordinate [length], or angle [rad]
  double last = 0.0;  ///< the bodies end there
  double reach = 0.0; ///< what is nearer to the axis of a round one lies on it [length]

  /// Thickness [length], or the angle that the solid takes of a whole turn [rad].
  [[nodiscard]] double depth() const { return last - first; }
  /// The direction of space that is x (0) or y (1) of the section; along an axis right-handed.
  [[nodiscard]] int space_direction_index(int d) const;
  /// A place of space in the section: along the axis the other two coordinates, about it the radius
  /// and the height.
  [[nodiscard]] base::Vec3 section_coordinates(const base::Vec3& x) const;
  /// The place of space that lies there at a coordinate or an angle.
  [[nodiscard]] base::Vec3 space_point(const base::Vec3& place, double along) const;
  /// Coordinate or angle of a place, from -pi to pi.
  [[nodiscard]] double normal_coordinate(const base::Vec3& x) const;
  /// The unit direction in which it grows; zero on the axis of a round one.
  [[nodiscard]] base::Vec3 normal(const base::Vec3& x) const;
};

} // namespace spricka::sense
