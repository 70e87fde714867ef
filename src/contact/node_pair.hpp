// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"

#include <vector>

namespace spricka::contact {

/// A contact node and what lies opposite.
struct NodePair {
  base::NodeId node;
  base::NodeId other; ///< invalid where the target has no nodes
  /// Forces of a unit traction on the node: along the normal towards the target, then along
  /// tangents where rows along the surface are wanted. [direction, area]
  std::vector<base::Vec3> push;
  double area = 0.0;
  double gap = 0.0; ///< [length]
};

/// Appends the rows of two nodes to those of a pair: the normal one, then one for each tangent.
void append_node_rows(const NodePair& nodes, PairConstraints& pair);

} // namespace spricka::contact
