// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/placement.hpp"
#include "mesh/link/grading.hpp"

#include <array>
#include <vector>

namespace spricka::mesh {

/// Length of a crack in the frame its placement is given in; half of it where both ends are tips.
double crack_length_in_frame(const CrackPlacement& placement);

/// Asks along cracks for elements that are no longer than the gap to what runs beside them is wide:
/// other cracks, a crack's own folds, the boundary (ends and middles of its edges) but near the
/// mouth. All in one frame.
void add_gap_sizes(const std::vector<const CrackPlacement*>& cracks,
                   const std::vector<std::array<base::Vec2, 3>>& boundary, Grading& size);

} // namespace spricka::mesh
