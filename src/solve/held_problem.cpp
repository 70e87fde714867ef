// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/held_problem.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::solve {

double load_scale(const ContactProblem& problem) {
  double scale = problem.load_scale;
  if (problem.h.size() > 0) {
    scale = std::max(scale, problem.h.cwiseAbs().maxCoeff());
  }
  const double stiffest = problem.b.size() > 0 ? problem.W.diagonal().maxCoeff() : 0.0;
  if (stiffest > 0.0 && problem.B.size() > 0) {
    double opened = problem.B.cwiseAbs().maxCoeff();
    if (opened < uncontrollable_opening * problem.opening_scale) {
      opened = problem.opening_scale; // no row feels any mode: what it would if it stood across it
    }
    scale = std::max(scale, opened * problem.b.cwiseAbs().maxCoeff() / stiffest);
  }
  return scale;
}

namespace {

/// Rigid bodies have no compliance to compare with: what makes forces and gaps alike. Without gaps
/// there is no length at all: next to none, lest round-off of forces show as motions.
double rigid_compliance(const ControllableProblem& held) {
  const double load = held.h.cwiseAbs().maxCoeff();
  const double gap = held.b.cwiseAbs().maxCoeff();
  if (load > 0.0) {
    return gap > 0.0 ? gap / load : 1e-50 / load;
  }
  return 1.0;
}

} // namespace

ControllableProblem restrict_to_controllable_modes(const ContactProblem& problem,
                                                   const ModeSplit& split) {
  ControllableProblem held{.W = problem.W,
                           .B = problem.B * split.controllable,
                           .b = problem.b,
                           .h = split.controllable.transpose() * problem.h,
                           .equality = problem.equality,
                           .tau = 0.0,
                           .d = {}};
  // The largest opening of each mode is 1: rows that open by round-off of it must not seem to hold
  // a mode that the others leave free.
  held.B = held.B.unaryExpr([](double opened) {
    constexpr double round_off = 1e-12;
    return std::abs(opened) > round_off ? opened : 0.0;
  });
  held.equality.resize(static_cast<std::size_t>(held.rows()), false);
  const base::Vector border = held.B.rowwise().squaredNorm();
  if (held.mode_count() > 0) {
    const double compliance = problem.W.trace();
    held.tau = compliance > 0.0 ? compliance / border.sum() : rigid_compliance(held);
  }
  held.d = (problem.W.diagonal() + held.tau * border).cwiseMax(0.0).cwiseSqrt();
  return held;
}

} // namespace spricka::solve
