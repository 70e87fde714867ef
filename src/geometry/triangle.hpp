// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <array>

namespace spricka::geometry {

/// The point of a triangle that is nearest to another point, and what it lies on: a corner, else an
/// edge (edge i runs from corner i to the next), else within.
struct NearestTrianglePoint {
  base::Vec3 x = base::Vec3::Zero();
  int corner = -1; ///< -1: none
  int edge = -1;   ///< -1: none
};

/// By the regions of the triangle's plane (Ericson 2005, section 5.1.5).
NearestTrianglePoint nearest_point(const base::Vec3& x, const std::array<base::Vec3, 3>& triangle);

} // namespace spricka::geometry
