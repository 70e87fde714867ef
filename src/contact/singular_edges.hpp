// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"

#include <vector>

namespace spricka::contact {

/// The edges at which one surface of a pair ends while the other goes on. In the plane these are
/// the ends of its chains, in the order of the contact surface; corners that stand on a rigid
/// target are not among them: a right angle has a bounded pressure there. In space they are edges
/// of its smooth parts, each connected line once: the rim of a punch, the end of a pin within a
/// longer bore; where both end together within a tenth of an edge there is none, and rigid targets
/// have no end. None on crack faces.
std::vector<SingularContactEdge> find_singular_edges(const PairConstraints& pair);

} // namespace spricka::contact
