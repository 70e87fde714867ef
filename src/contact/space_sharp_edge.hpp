// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"

#include <vector>

namespace spricka::contact {

/// Edges at which a smooth part of one solid surface of a pair ends while the other goes on, each
/// connected line of edges once: the rim of a punch, the end of a pin within a longer bore. Where
/// both end together within a tenth of an edge there is none.
std::vector<SingularContactEdge> find_space_singular_edges(const PairConstraints& pair);

} // namespace spricka::contact
