// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace spricka::sense {

/// A point that lies off the line of the others. Angles are what the line turns by from point to
/// point, in all [rad].
struct MisplacedFrontPoint {
  std::size_t point = 0;
  double turning = 0.0;
  double without = 0.0; ///< the line without that point
};

/// The worst one of points that draw a smooth line (closed: from the last to the first, too). A
/// smooth line turns by what its shape turns by, however many points draw it, and hardly less
/// without one of them; a mistyped point makes it turn there and back. Empty: there is none, or
/// there are too few points to tell.
std::optional<MisplacedFrontPoint> find_misplaced_front_point(const std::vector<base::Vec3>& points,
                                                              bool closed);

} // namespace spricka::sense
