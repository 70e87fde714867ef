// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/held_problem.hpp"
#include "solve/mode_split.hpp"

namespace spricka::solve {

/// Motions that no pressed row stops leave forces and energy as they are: of all such answers the
/// one with the least modes |felt alpha|, gaps kept non-negative (least distance programming,
/// Lawson and Hanson 1974, chapter 23). Rows press that give a mode more than `least`. alpha [m] is
/// changed; returns the number of free motions.
int rest_free_motions(const HeldProblem& problem, const ModeSplit& split,
                      const base::Vector& lambda, double least, base::Vector& alpha);

} // namespace spricka::solve
