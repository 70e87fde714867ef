// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <optional>
#include <vector>

namespace spricka::contact {

/// Part of the largest pressure: where there is less nothing is looked at.
inline constexpr double least_looked_at = 0.01;

/// Where thrust acts on the target, once displacements have taken it there; of a rigid target where
/// the contact side is then.
struct DisplacedContactPoint {
  base::Vec3 x = base::Vec3::Zero();
  double thrust = 0.0; ///< [force]
  double gap = 0.0;    ///< as rows count it, to the contact side [length]
  /// Gap of the deformed bodies that no row counts [length]; none: nothing stands opposite any
  /// more.
  std::optional<double> unseen;
  base::Vec3 normal = base::Vec3::Zero(); ///< along which the gap counts, from the contact side
  /// [3, motion] by which each motion that was asked for moves the target past the contact side
  base::Matrix relative_motions;
};

/// How far the pressed part of a pair has moved.
struct SlideMeasures {
  double thrust = 0.0; ///< sum of pressure times area [force]
  /// Part of the thrust that acts where nothing stands opposite any more.
  double unsupported_part = 0.0;
  double way = 0.0;     ///< largest slide of one side along the other [length]
  double facet = 0.0;   ///< length of the longer facet of either side where that is
  double pressed = 0.0; ///< length of the pressed part; in space, as of facets, root of the area
  double misfit = 0.0;  ///< largest gap of the deformed bodies that no row counts [length]
  std::vector<DisplacedContactPoint> places;
};

} // namespace spricka::contact
