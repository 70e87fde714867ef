// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace spricka::contact {

/// Part of the largest pressure: where there is less nothing is looked at.
inline constexpr double least_looked_at = 0.01;

/// How far the pressed part of a pair has moved.
struct Slide {
  double lost = 0.0;    ///< part of the thrust that acts where nothing stands opposite any more
  double way = 0.0;     ///< largest slide of one side along the other [length]
  double facet = 0.0;   ///< longest edge of either side where that is [length]
  double pressed = 0.0; ///< length of the pressed part
  double misfit = 0.0;  ///< largest gap of the deformed bodies that no row counts [length]
};

} // namespace spricka::contact
