// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/friction_set.hpp"

#include <vector>

namespace spricka::solve {

struct FrictionSearchResult {
  bool settled = false;
  std::vector<SlipState> touch;
  SlipStateSolution solution;
};

/// States of all rows in which no condition is violated, with modes that nothing holds anchored at
/// `anchor`: Newton from `start`, Lemke's pivoting, and Newton from other starts. Iterations and
/// pivots are added to `figures`.
FrictionSearchResult find_consistent_states(const ScaledFrictionProblem& problem,
                                            const base::Vector& anchor,
                                            const std::vector<SlipState>& start,
                                            const ContactSettings& settings,
                                            ContactSolution& figures);

} // namespace spricka::solve
