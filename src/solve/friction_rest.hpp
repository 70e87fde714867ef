// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/held_problem.hpp"
#include "solve/mode_split.hpp"
#include "solve/round_friction.hpp"

namespace spricka::solve {

/// Brings bodies to rest that no point in contact holds: they stay at `anchor` [m, scaled modes],
/// as far as the others let them (solve.20), where Newton's method leaves them anywhere along what
/// they are free to do. A point holds that is closed and whose pressure, or the shear that its
/// friction can bear, loads some mode by more than `least`. Changes motions, gaps and states of
/// points that do not hold; returns the number of free motions.
int move_unheld_bodies_to_anchor(const ControllableProblem& held, const ModeSplit& split,
                                 const RoundConeFrictionProblem& scaled, const base::Vector& anchor,
                                 double least, RoundFrictionState& found);

} // namespace spricka::solve
