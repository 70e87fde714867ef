// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"

namespace spricka::contact {

/// A contact node and what lies opposite.
struct NodePair {
  base::NodeId node;
  base::NodeId other;                   ///< invalid where the target has no nodes
  base::Vec3 push = base::Vec3::Zero(); ///< unit pressure on the node, towards the target [area]
  double area = 0.0;
  double gap = 0.0; ///< [length]
};

/// Appends the normal row of two nodes, and if asked that along the surface, the push turned to the
/// left in the plane.
void append_node_rows(const NodePair& nodes, bool tangents, PairConstraints& pair);

} // namespace spricka::contact
