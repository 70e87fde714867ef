// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/index.hpp"
#include "contact/constraint.hpp"
#include "contact/pair_pressure.hpp"

#include <map>
#include <vector>

/// What pressures are recovered from, in the plane and in space.
namespace spricka::contact {

/// What the rows of a pair have come to.
struct ContactRowValues {
  const base::Vector& lambda;      ///< multipliers [normal rows, then tangent rows] [stress]
  const base::Vector& gap;         ///< weighted [normal rows] [length * area]
  const std::vector<bool>& closed; ///< [normal rows]
  bool may_pull = false;           ///< a bonded pair, whose pressures may be negative

  /// Gives a node the row of a pair, its state and its gap.
  void assign_row_to_node(const PairConstraints& pair, std::size_t row, NodePressure& node) const {
    node.row = static_cast<int>(row);
    node.closed = closed[row];
    node.gap = gap[base::index(row)] / pair.normal[row].area;
  }
};

/// What the multipliers put on the contact side of a pair.
struct ContactSideNodalForces {
  std::map<base::NodeId, base::Vec3> x;    ///< all nodes of the contact side
  std::map<base::NodeId, base::Vec3> node; ///< on nodes that rows weigh [force]
  base::Vec3 total = base::Vec3::Zero();
  base::Vec3 moment = base::Vec3::Zero(); ///< about the origin
};

} // namespace spricka::contact
