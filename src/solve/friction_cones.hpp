// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "solve/friction_problem.hpp"
#include "solve/held_problem.hpp"
#include "solve/load_balance.hpp"
#include "solve/mode_split.hpp"

#include <vector>

namespace spricka::solve {

/// The cones of all forces that rows can give, by their edges, as the rows of a problem without
/// compliance and gaps: pairs of rows with friction become normal + mu tangent and normal - mu
/// tangent, so that any force is a sum of edges with coefficients >= 0 (equality rows: of any
/// sign). Round cones become those of sixteen sides about them, with more rows behind the others.
/// B [n, m] and loads h [m] on the modes.
ControllableProblem cone_edge_balance_problem(const base::Matrix& B, const base::Vector& h,
                                              const std::vector<bool>& equality,
                                              const std::vector<FrictionRow>& friction);

/// The balance of the loads on the modes by forces in the round cones themselves, of which edges
/// are added where a remainder leans on them. A remainder is given only where it is certain.
LoadBalance balance_round_cones(const ControllableProblem& held,
                                const std::vector<FrictionRow>& friction);

/// The motion [m] in which bodies slide, from what the cones cannot hold (`balance`): along rows,
/// not off them.
base::Vector sliding_motion(const ModeSplit& split, const ControllableProblem& held,
                            const std::vector<FrictionRow>& friction, const LoadBalance& balance);

} // namespace spricka::solve
