// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/path_parts.hpp"
#include "base/index.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::solve {

using base::at;
using base::index;

ContactProblem path_direction_problem(const ParametricProblem& problem,
                                      const std::vector<int>& rows,
                                      const std::vector<bool>& pressing, double length) {
  const ContactProblem& whole = problem.at_zero;
  const auto k = index(rows.size());
  ContactProblem rate;
  // (solve.13) with b' and h' in place of b and h; compliances are those of the problem itself.
  rate.W.resize(k, k);
  rate.B.resize(k, whole.B.cols());
  rate.b.resize(k);
  rate.h = problem.dh;
  // Loads by t: over the whole path they amount to what the loads themselves are judged by.
  rate.load_scale = whole.load_scale / length;
  // Of all rows: among these few alone a mode might look as if it opened much.
  rate.opening_scale =
      std::max(whole.opening_scale, whole.B.size() > 0 ? whole.B.cwiseAbs().maxCoeff() : 0.0);
  rate.equality = pressing;
  for (Eigen::Index c = 0; c < k; ++c) {
    const int i = rows[at(c)];
    for (Eigen::Index r = 0; r < k; ++r) {
      rate.W(r, c) = whole.W(rows[at(r)], i);
    }
    rate.B.row(c) = whole.B.row(i);
    rate.b(c) = problem.db(i);
  }
  return rate;
}

double path_residual(const ControllableProblem& problem, const SweptMatrix& matrix,
                     const base::Vector& state, const PathResidualScale& scale) {
  const base::Vector lambda = matrix.forces(state);
  const base::Vector reported = matrix.open_gaps(state);
  const base::Vector gap =
      problem.b + problem.W * lambda + problem.B * matrix.mode_amplitudes(state);
  double worst = 0.0;
  for (int i = 0; i < problem.rows(); ++i) {
    const double size = scale.size + scale.level(i);
    if (!(size > 0.0)) {
      continue;
    }
    // Gaps in the problem's own units; state and scales are in units of d.
    const double d = (problem.d(i) > 0.0 ? problem.d(i) : 1.0) * size;
    worst = std::max(worst, std::abs(gap(i) - reported(i)) / d);
    // equality rows left out as redundant must hold all the same
    worst = std::max(worst, problem.equality[at(i)] ? std::abs(gap(i)) / d
                                                    : std::max(-state(i), 0.0) / size);
  }
  const base::Vector balance = problem.h + problem.B.transpose() * lambda;
  // One scale for all modes: a mode without loads has nothing of its own to be measured by.
  const base::Vector terms = scale.load + problem.B.cwiseAbs().transpose() * lambda.cwiseAbs();
  const double largest = terms.size() > 0 ? terms.maxCoeff() : 0.0;
  return largest > 0.0 ? std::max(worst, balance.cwiseAbs().maxCoeff() / largest) : worst;
}

} // namespace spricka::solve
