// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/held_problem.hpp"
#include "solve/contact_qp.hpp"

namespace spricka::solve {

namespace {

/// Rigid bodies have no compliance to compare with: what makes forces and gaps alike.
double rigid_compliance(const HeldProblem& held) {
  const double load = held.h.cwiseAbs().maxCoeff();
  const double gap = held.b.size() > 0 ? held.b.cwiseAbs().maxCoeff() : 0.0;
  return load > 0.0 && gap > 0.0 ? gap / load : 1.0;
}

} // namespace

HeldProblem held_problem(const ContactProblem& problem, const base::Matrix& felt) {
  HeldProblem held{.W = problem.W,
                   .B = problem.B * felt,
                   .b = problem.b,
                   .h = felt.transpose() * problem.h,
                   .equality = problem.equality,
                   .tau = 0.0,
                   .d = {}};
  held.equality.resize(static_cast<std::size_t>(held.rows()), false);
  const base::Vector border = held.B.rowwise().squaredNorm();
  if (held.modes() > 0) {
    const double compliance = problem.W.trace();
    held.tau = compliance > 0.0 ? compliance / border.sum() : rigid_compliance(held);
  }
  held.d = (problem.W.diagonal() + held.tau * border).cwiseMax(0.0).cwiseSqrt();
  return held;
}

} // namespace spricka::solve
