// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"

#include <optional>

namespace spricka::contact {

/// Fills the rows of a pair of solid surfaces whose nodes lie opposite each other: one for each
/// node and smooth part. A node stands for the integral of its shape function, on faces of 6 nodes
/// for that of its hat, since a uniform pressure puts nothing on their corners; on those of 8 nodes
/// it pulls at corners, and the pair is refused. `tangents`: two rows along the surface for each.
void space_node_rows(PairConstraints& pair, std::optional<double> declared_gap, bool tangents);

} // namespace spricka::contact
