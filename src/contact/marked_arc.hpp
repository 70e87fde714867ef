// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/arc.hpp"

#include <vector>

namespace spricka::contact {

/// A node of a contact surface, to find a part of the contact such as the sticking one.
struct ContactArcNode {
  double s = 0.0;        ///< place along the surface [length]; an angle [rad] where it is round
  bool in = false;       ///< whether the node belongs to the part
  double strength = 0.0; ///< falls to zero at the ends of the part; sticking: mu p - |q| [stress]
};

/// The longest run of nodes that belong to the part. Its ends lie where strength^2 of the last two
/// nodes, carried on linearly, is zero (square-root law). `round`: s is an angle and closes on
/// itself.
SurfaceInterval longest_marked_arc(std::vector<ContactArcNode> nodes, bool round);

} // namespace spricka::contact
