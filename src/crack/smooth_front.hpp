// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <optional>
#include <vector>

/// Values along a front as a smooth curve, for growth.
namespace spricka::crack {

/// Where the points of a front are, and how much each counts.
struct FrontStations {
  std::vector<double> s;      ///< ascending
  std::vector<double> weight; ///< positive; 0: the point has no value of its own
  /// Whether a value is that at the place, not the mean over the point's hat; empty: none is.
  std::vector<bool> local{};
  double length = 0.0; ///< of a closed front
  bool closed = false;
};

/// The cubic spline with a knot at every second point whose means over the points' hats fit the
/// values [point, quantity] best, at the points (crack_space.15). Fewer than 5 points that count:
/// the values themselves.
base::Matrix smooth_values_along_front(const FrontStations& at, const base::Matrix& values);

/// A place of a front, and how far values beside it are looked at [length].
struct ExtrapolationRange {
  double s = 0.0, far = 0.0;
};
/// The value at a place whose own says nothing, by a parabola through the values of the points next
/// to it that count: all that are nearer than `far`, five at least, more (nine at most) where
/// errors of theirs would count 1.5 times; a line through two or three, nothing with fewer
/// (crack_space.16). [quantity]
std::optional<base::Vector> extrapolate_front_value(const FrontStations& at,
                                                    const base::Matrix& values,
                                                    const ExtrapolationRange& beside);

} // namespace spricka::crack
