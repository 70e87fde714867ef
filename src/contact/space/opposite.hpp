// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cmath>
#include <cstddef>
#include <limits>

/// What stands opposite, in the plane and in space.
namespace spricka::contact {

/// What lies farther off than this part of the contact surface's extent is not opposite.
inline constexpr double farthest_opposite = 0.2;

/// A measured gap, or zero where sixteen digits of coordinates as large as `largest` cannot tell it
/// from that: bodies that touch put no force on each other.
inline double zero_gap_below_round_off(double gap, double largest) {
  constexpr double digits = 8.0 * std::numeric_limits<double>::epsilon();
  return std::abs(gap) <= digits * largest ? 0.0 : gap;
}

/// Elements of a surface that threads look at before what they found is taken in order.
inline constexpr std::size_t elements_at_a_time = 256;

} // namespace spricka::contact
