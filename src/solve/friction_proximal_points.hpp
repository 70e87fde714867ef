// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/round_friction.hpp"

namespace spricka::solve {

/// Solves an increment whose Newton steps run in circles. Where rows move nearly together, as a
/// seat and the friction beside it that pushes the same way, forces that cancel each other hardly
/// open a gap: a small overlap asks for forces as large as all others, which open these rows and
/// let others slip, and so on. A compliance c of its own for every row ends that: gaps become
/// g + c (lambda - lambda_k) with the forces lambda_k found last, so that the answer is that
/// without c once forces no longer change (proximal point method, Rockafellar 1976; around Newton's
/// method of round cones, Acary, Bremond and Huber 2018). It falls after each answer and rises
/// where there is none. Begins without forces from motions `alpha` [m]; returns the nearer of its
/// answer and `found`, with the steps of both.
RoundFrictionState solve_by_proximal_points(const RoundConeFrictionProblem& problem,
                                            const base::Vector& alpha,
                                            const RoundFrictionState& found);

} // namespace spricka::solve
