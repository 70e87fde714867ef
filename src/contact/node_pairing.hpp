// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"

#include <optional>

namespace spricka::contact {

/// Fills the rows of a NODE pair (matching nodes; manual, contact.5) whose two surfaces stand in
/// `pair`: each contact node with the target node on its normal. Rows are scaled by the lumped
/// area of the node. Without a partner within 1e-3 of the edge length off the normal the pair is
/// in `trouble`.
void node_rows(PairConstraints& pair, std::optional<double> declared_gap, bool tangents);

} // namespace spricka::contact
