// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "estimate/corners.hpp"

#include <vector>

namespace spricka::estimate {

/// A goal that hangs on supports of single nodes: a body gives way there by log h, without bound.
struct PointSupportRefinementChange {
  base::Vector change; ///< [goals] sum of |dK| when elements at such nodes halve (estimate.18)
  base::NodeId node;   ///< that has the largest part; invalid: no support of a single node
};

/// reaction [2 * node] of the supports; z [2 * node, goals] the adjoints. Zero where supports are
/// statically determinate: their reactions to the goals' loads, which balance, are none.
PointSupportRefinementChange
point_support_refinement_change(const CornerSearchInput& setting,
                                const std::vector<SingularCorner>& corners,
                                const base::Vector& reaction, const base::Matrix& z);

} // namespace spricka::estimate
