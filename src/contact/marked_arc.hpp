// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/arc.hpp"

#include <vector>

namespace spricka::contact {

/// A node of a contact surface: whether it belongs to the part that is looked for (sticking),
/// and what falls to zero at the end of that part (what the shear lacks).
struct ArcNode {
  double s = 0.0; ///< along the surface; an angle [rad] where it is round
  bool in = false;
  double strength = 0.0;
};

/// The longest run of nodes of that part. Its ends lie where strength^2 of the last two nodes,
/// carried on linearly, is zero (square-root law). `round`: s closes on itself.
Arc marked_arc(std::vector<ArcNode> nodes, bool round);

} // namespace spricka::contact
