// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/friction_search.hpp"
#include "base/index.hpp"
#include "solve/lemke.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace spricka::solve {

using base::at;

namespace {

constexpr double loose_tolerance = 1e-9; ///< of signs where rows hang in the balance
constexpr int coverings = 2;             ///< tried by Lemke's pivoting

/// Semi-smooth Newton method: all rows whose condition is violated change at once (Alart and
/// Curnier 1991; Hueeber, Stadler and Wohlmuth 2008) until none is left or states come back.
FrictionSearchResult newton(const ScaledFrictionProblem& problem, const base::Vector& anchor,
                            std::vector<SlipState> touch, double tolerance,
                            std::pair<int, int&> limit) {
  FrictionSearchResult search;
  std::set<std::vector<SlipState>> met;
  for (int k = 0; k < limit.first && met.insert(touch).second; ++k) {
    ++limit.second;
    search.solution = solve_slip_states(problem, touch, anchor);
    if (!search.solution.regular) {
      break;
    }
    search.touch = touch;
    if (update_slip_states(problem, search.solution, tolerance, touch) == 0) {
      search.settled = true;
      break;
    }
  }
  return search;
}

/// One row at a time, the first that is wrong (Murty 1974): finite where the answer is unique, and
/// another way where it is not.
FrictionSearchResult one_by_one(const ScaledFrictionProblem& problem, const base::Vector& anchor,
                                std::vector<SlipState> touch, double tolerance,
                                std::pair<int, int&> limit) {
  FrictionSearchResult search;
  for (int k = 0; k < limit.first; ++k) {
    ++limit.second;
    search.solution = solve_slip_states(problem, touch, anchor);
    if (!search.solution.regular) {
      break;
    }
    search.touch = touch;
    std::vector<SlipState> next = touch;
    if (update_slip_states(problem, search.solution, tolerance, next) == 0) {
      search.settled = true;
      break;
    }
    for (const ScaledFrictionProblem::FrictionUnit& u : problem.units) {
      const auto n = std::size_t(u.normal);
      if (next[n] != touch[n]) {
        touch[n] = next[n];
        if (u.tangent >= 0) {
          touch[at(u.tangent)] = next[n];
        }
        break;
      }
    }
  }
  return search;
}

/// The increment as one linear complementarity problem: z the opening of each unit and its slip
/// forward and backward, w the pressure and what the force lacks to slip (manual, solve.23).
struct Complementarity {
  base::Matrix M;
  base::Vector q;
  std::vector<int> forward; ///< [unit] place of its forward slip in z, backward behind it; or -1
};

Complementarity complementarity(const ScaledFrictionProblem& problem,
                                const InterfaceStiffness& face) {
  const int units = static_cast<int>(problem.units.size());
  const int rows = static_cast<int>(face.rows.size());
  const int n = units + 2 * (rows - units);
  Complementarity lcp{base::Matrix(n, n), base::Vector(n), {}};
  base::Matrix columns(rows, n); // what z does to all forces
  columns.leftCols(units) = face.A.leftCols(units);
  int column = units;
  int tangent = units;
  for (const ScaledFrictionProblem::FrictionUnit& u : problem.units) {
    lcp.forward.push_back(u.tangent < 0 ? -1 : column);
    if (u.tangent >= 0) {
      columns.col(column) = face.A.col(tangent);
      columns.col(column + 1) = -face.A.col(tangent);
      column += 2;
      ++tangent;
    }
  }
  // (solve.23): pressures above, then what shear may still grow by, forward and backward.
  lcp.M.topRows(units) = columns.topRows(units);
  lcp.q.head(units) = face.q.head(units);
  tangent = units;
  for (int i = 0; i < units; ++i) {
    const int f = lcp.forward[at(i)];
    if (f < 0) {
      continue;
    }
    const double mu = problem.units[at(i)].mu;
    lcp.M.row(f) = mu * columns.row(i) + columns.row(tangent);
    lcp.M.row(f + 1) = mu * columns.row(i) - columns.row(tangent);
    lcp.q(f) = mu * face.q(i) + face.q(tangent);
    lcp.q(f + 1) = mu * face.q(i) - face.q(tangent);
    ++tangent;
  }
  return lcp;
}

/// The finite fallback; the states it ends in, or none.
std::vector<SlipState> pivoted(const ScaledFrictionProblem& problem, const base::Vector& anchor,
                               int max_pivots, int& pivots) {
  const InterfaceStiffness face = interface_stiffness(problem, anchor);
  if (!face.regular) {
    return {};
  }
  const Complementarity lcp = complementarity(problem, face);
  const double scale = lcp.q.size() > 0 ? lcp.q.cwiseAbs().maxCoeff() : 0.0;
  const base::Vector q = scale > 0.0 ? base::Vector(lcp.q / scale) : lcp.q;
  LemkeResult result;
  for (int turn = 0; turn < coverings && !result.solved; ++turn) { // a ray depends on the covering
    base::Vector cover = base::Vector::Ones(q.size());
    for (Eigen::Index i = 0; i < q.size(); ++i) {
      cover(i) += turn * std::fmod(0.6180339887498949 * static_cast<double>(i * turn + 1), 1.0);
    }
    result = solve_by_lemke_pivoting(lcp.M, q, cover, max_pivots - pivots);
    pivots += result.pivots;
  }
  if (!result.solved) {
    return {};
  }
  std::vector<SlipState> touch(std::size_t(problem.rows()), SlipState::stick);
  for (std::size_t i = 0; i < problem.units.size(); ++i) {
    const ScaledFrictionProblem::FrictionUnit& u = problem.units[i];
    const int f = lcp.forward[i];
    // An opening in the basis: the row is open. One of its slips in the basis: it slips that way.
    SlipState state = result.basic[i] ? SlipState::open : SlipState::stick;
    if (f >= 0 && state == SlipState::stick) {
      const bool forward = result.basic[at(f)];
      const bool backward = result.basic[at(f) + 1];
      state = forward == backward ? SlipState::stick
              : forward           ? SlipState::forward
                                  : SlipState::backward;
    }
    touch[at(u.normal)] = state;
    if (u.tangent >= 0) {
      touch[at(u.tangent)] = state;
    }
  }
  return touch;
}

} // namespace

FrictionSearchResult find_consistent_states(const ScaledFrictionProblem& problem,
                                            const base::Vector& anchor,
                                            const std::vector<SlipState>& start,
                                            const ContactSettings& settings,
                                            ContactSolution& figures) {
  FrictionSearchResult search = newton(problem, anchor, start, settings.tolerance,
                                       {settings.max_block_iterations, figures.block_iterations});
  if (!search.settled) {
    const std::vector<SlipState> touch =
        pivoted(problem, anchor, settings.max_pivots, figures.pivots);
    if (!touch.empty()) {
      // The pivots' answer holds the round-off of its tableau: its states are checked by equations
      // of their own, and rows in the balance may stay as they are.
      search = newton(problem, anchor, touch, std::max(loose_tolerance, settings.tolerance),
                      {settings.max_block_iterations, figures.block_iterations});
    }
  }
  // Newton's end depends on its start: the two plainest, each once.
  for (const SlipState all : {SlipState::stick, SlipState::open}) {
    if (!search.settled) {
      search = newton(problem, anchor, std::vector<SlipState>(start.size(), all),
                      std::max(loose_tolerance, settings.tolerance),
                      {settings.max_block_iterations, figures.block_iterations});
    }
  }
  if (!search.settled) {
    search = one_by_one(problem, anchor, start, std::max(loose_tolerance, settings.tolerance),
                        {settings.max_block_iterations, figures.block_iterations});
  }
  return search;
}

} // namespace spricka::solve
