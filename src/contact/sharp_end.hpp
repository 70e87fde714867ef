// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"

#include <vector>

namespace spricka::contact {

/// All sharp ends of a pair, in the order of the contact surface. Corners that stand on a rigid
/// target are not among them: a right angle has a bounded pressure there.
std::vector<SingularContactEdge> find_singular_edges(const PairConstraints& pair);

} // namespace spricka::contact
