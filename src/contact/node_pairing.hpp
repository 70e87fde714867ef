// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"

#include <optional>

namespace spricka::contact {

/// Fills the rows of a NODE pair (matching nodes; manual, contact.5) whose two surfaces stand in
/// `pair`: each contact node, in space on each smooth part, with the target node on its normal.
/// Rows are scaled by the area of the node, the integral of its shape function; on faces of 6 nodes
/// that of its hat, since a uniform pressure puts nothing on their corners. `tangents`: with all
/// rows along the surface. The pair is in `trouble` without a partner within 1e-3 of the facets'
/// size off the normal; in space also before a rigid target and on faces of 8 nodes, where a
/// uniform pressure pulls at corners.
void fill_node_pair_rows(PairConstraints& pair, std::optional<double> declared_gap, bool tangents);

} // namespace spricka::contact
