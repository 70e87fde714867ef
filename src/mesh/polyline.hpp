// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <cstddef>
#include <limits>
#include <vector>

/// Lines through points in space, straight between them. Closed ones end with their first point.
namespace spricka::mesh {

/// A place on a line.
struct PolylinePosition {
  std::size_t piece = 0;                                ///< from this point to the next
  double part = 0.0;                                    ///< of the piece
  double distance = std::numeric_limits<double>::max(); ///< of what it was looked for from there

  /// Between two values that points have.
  [[nodiscard]] base::Vec3 interpolate(const std::vector<base::Vec3>& values) const {
    return values[piece] + part * (values[piece + 1] - values[piece]);
  }
};

/// Where a line [>= 2 points] is nearest to x.
PolylinePosition nearest_on(const std::vector<base::Vec3>& line, const base::Vec3& x);

/// The direction of a line at one of its points, unit.
base::Vec3 direction_at(const std::vector<base::Vec3>& line, std::size_t point);

} // namespace spricka::mesh
