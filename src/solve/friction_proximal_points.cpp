// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/friction_proximal_points.hpp"

#include "solve/contact_problem.hpp"

namespace spricka::solve {

namespace {

constexpr int most_points = 30;
constexpr int most_steps = 25;    // of Newton's method for a proximal point
constexpr double fall = 0.1;      // of the compliance, after an answer
constexpr double rise = 3.0;      // where there is none
constexpr double largest = 10.0;  // beside a row's own compliance, which is about 1
constexpr double smallest = 1e-9; // below it helps no longer

} // namespace

RoundFrictionState solve_by_proximal_points(const RoundConeFrictionProblem& problem,
                                            const base::Vector& alpha,
                                            const RoundFrictionState& found) {
  RoundConeFrictionProblem soft = problem;
  PredictedContactForces last{.lambda = base::Vector::Zero(problem.rows()), .alpha = alpha};
  RoundFrictionState best = found;
  int steps = found.newton_steps;
  double compliance = 1.0;
  for (int k = 0; k < most_points && compliance > smallest && compliance < largest; ++k) {
    soft.W.diagonal() = problem.W.diagonal().array() + compliance;
    soft.b = problem.b - compliance * last.lambda;
    const RoundFrictionState pressed =
        iterate_round_friction_newton(soft, last, most_steps, near_enough);
    steps += pressed.newton_steps;
    if (!(pressed.residual < accepted_residual)) {
      compliance *= rise;
      continue;
    }
    compliance *= fall;
    last = {.lambda = pressed.lambda, .alpha = pressed.alpha};
    RoundFrictionState now = iterate_round_friction_newton(problem, last, 0, 0.0);
    if (now.residual < accepted_residual) { // the states are right: Newton's method arrives alone
      now = iterate_round_friction_newton(problem, last, most_steps, 0.0);
      steps += now.newton_steps;
    }
    best = now.residual < best.residual ? now : best;
    if (best.residual < near_enough) {
      break;
    }
  }
  best.newton_steps = steps;
  best.sweeps = found.sweeps;
  return best;
}

} // namespace spricka::solve
