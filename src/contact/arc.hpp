// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/node_pressure.hpp"
#include "contact/surface.hpp"

#include <vector>

namespace spricka::contact {

/// A stretch of a surface: angles [rad] or lengths.
struct SurfaceInterval {
  double from = 0.0, to = 0.0;
};

/// The longest closed stretch of a surface: angles about its circle's centre [rad], `from` between
/// -pi and pi, a whole circle -pi .. pi; on straight surfaces lengths along the chain. `nodes` are
/// those of the chains, in order; `multipliers`: p_consistent holds the pressure, else p_lumped. A
/// stretch ends where a pressure like a square root with the force and moment of the last three
/// closed nodes does (contact.11), or with its surface; it goes on across a crack's mouth.
SurfaceInterval find_longest_closed_arc(const ContactSurface& surface,
                                        const std::vector<NodePressure>& nodes, bool multipliers);

} // namespace spricka::contact
