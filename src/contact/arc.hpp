// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/recovery.hpp"

#include <vector>

namespace spricka::contact {

/// Where contact begins and ends: angles on a circle [rad], lengths along the chain else.
struct Arc {
  double from = 0.0, to = 0.0;
};

/// The longest run of closed nodes; the whole circle is -pi to pi. `nodes` chain by chain as the
/// surface runs. Between a closed node and an open one the square root law finds the end
/// (contact.11); a run that reaches the end of a chain ends there. Chains that meet in one point of
/// a circle (the lips of a crack mouth) count as one.
Arc longest_arc(const Surface& surface, const std::vector<NodePressure>& nodes);

} // namespace spricka::contact
