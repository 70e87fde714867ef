// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <vector>

namespace spricka::contact {

/// Part of the largest pressure: where there is less nothing is looked at.
inline constexpr double least_looked_at = 0.01;

/// Where thrust acts on the target, once displacements have taken it there.
struct PressedPlace {
  base::Vec3 x = base::Vec3::Zero();
  double thrust = 0.0; ///< [force]
  double gap = 0.0;    ///< as rows count it, to the contact side [length]
};

/// How far the pressed part of a pair has moved.
struct Slide {
  double thrust = 0.0;  ///< sum of pressure times area [force]
  double lost = 0.0;    ///< part of the thrust that acts where nothing stands opposite any more
  double way = 0.0;     ///< largest slide of one side along the other [length]
  double facet = 0.0;   ///< longest edge of either side where that is [length]
  double pressed = 0.0; ///< length of the pressed part
  double misfit = 0.0;  ///< largest gap of the deformed bodies that no row counts [length]
  std::vector<PressedPlace> places; ///< but of rigid targets
};

} // namespace spricka::contact
