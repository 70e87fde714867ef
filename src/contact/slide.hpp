// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"

/// Whether displacements are still as small as contact needs: it pairs the bodies as drawn.
namespace spricka::contact {

/// How far the pressed part of a pair has moved.
struct Slide {
  double lost = 0.0;    ///< part of the thrust that acts where nothing stands opposite any more
  double way = 0.0;     ///< largest slide of one side along the other [length]
  double facet = 0.0;   ///< longest edge of either side where that is [length]
  double pressed = 0.0; ///< length of the pressed part
  double misfit = 0.0;  ///< largest gap of the deformed bodies that no row counts [length]
};

/// Measures the slide of a pair under multipliers lambda [normal rows, then tangents] [stress] with
/// displacements u [2 * node] [length].
Slide slide_of(const PairRows& pair, const base::Vector& lambda, const base::Vector& u);

} // namespace spricka::contact
