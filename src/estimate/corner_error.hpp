// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "estimate/corners.hpp"
#include "estimate/goal_error.hpp"

#include <vector>

namespace spricka::estimate {

/// Error over what cubics see of it at a corner (manual, estimate.17).
double corner_error_factor(double exponent);

/// What the errors at corners are found from, and what they were found to be without them.
struct CornerErrorRequest {
  const CubicEnrichment& enrichment;
  const ModeFreedomMap& map;
  const GoalErrorInput& goal;
  const std::vector<bool>& fixed; ///< [2 * node] freedoms that nothing moves further
};

/// Replaces what the elements at a corner have of each error by r_z^T S^-1 r_u of the elements
/// about it, nodes and modes together, times unseen_factor (estimate.16). Corners whose parts
/// change nothing that counts are left. Elements elsewhere whose material hardly changes its volume
/// have their shares raised by what modes alone see less of (estimate.19).
void correct_corner_errors(const CornerErrorRequest& request,
                           const std::vector<SingularCorner>& corners,
                           std::vector<GoalError>& errors);

} // namespace spricka::estimate
