// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/friction_index.hpp"
#include "base/index.hpp"
#include "solve/blas.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::solve {

using base::at;
using base::index;

namespace {

constexpr double singular = 1e-11; ///< a pivot below this part of the largest tells nothing

/// Sign of a determinant; 0 where round-off could have made it.
int determinant_sign(base::Matrix J) {
  const auto n = static_cast<int>(J.rows());
  if (n == 0) {
    return 1;
  }
  std::vector<int> swapped; // [row] with which one, counted from 1
  if (!blas::factorise_lu(n, blas::as_matrix_block(J), swapped)) {
    return 0;
  }
  const base::Vector pivots = J.diagonal();
  if (!(pivots.cwiseAbs().minCoeff() > singular * pivots.cwiseAbs().maxCoeff())) {
    return 0;
  }
  auto signs = (pivots.array() < 0.0).count();
  for (int i = 0; i < n; ++i) {
    signs += swapped[at(i)] != i + 1 ? 1 : 0;
  }
  return signs % 2 == 0 ? 1 : -1;
}

/// The derivative of the conditions of an answer by its forces and motions: columns are forces,
/// those of a sliding row with its friction.
base::Matrix jacobian(const FrictionProblem& problem, const std::vector<int>& rows,
                      const std::vector<double>& ratio, const std::vector<int>& tangent) {
  const ContactProblem& p = problem.contact;
  const auto n = index(rows.size());
  const Eigen::Index m = p.B.cols();
  base::Vector scale(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const int r = rows[at(i)];
    // Scaling by positive numbers leaves the sign and makes pivots comparable.
    scale(i) = p.W(r, r) > 0.0 ? 1.0 / std::sqrt(p.W(r, r)) : 1.0;
  }
  double motion = 0.0;
  base::Matrix J = base::Matrix::Zero(n + m, n + m);
  for (Eigen::Index j = 0; j < n; ++j) {
    const int c = rows[at(j)];
    const double mu = ratio[at(c)];
    const int t = tangent[at(c)];
    for (Eigen::Index i = 0; i < n; ++i) {
      const int r = rows[at(i)];
      J(i, j) = scale(i) * scale(j) * (p.W(r, c) + (mu != 0.0 ? mu * p.W(r, t) : 0.0));
    }
    for (Eigen::Index k = 0; k < m; ++k) {
      J(j, n + k) = scale(j) * p.B(c, k);
      J(n + k, j) = scale(j) * (p.B(c, k) + (mu != 0.0 ? mu * p.B(t, k) : 0.0));
      motion = std::max(motion, std::abs(J(j, n + k)));
    }
  }
  if (motion > 0.0) {
    J.rightCols(m) /= motion;
    J.bottomRows(m) /= motion;
  }
  return J;
}

/// The same where slips are vectors (solve.36): rows are conditions, of a sliding point those of
/// its two forces; `share` of friction counts.
base::Matrix round_jacobian(const FrictionProblem& problem, const FrictionSolution& solution,
                            double share) {
  const ContactProblem& p = problem.contact;
  const base::Vector& lambda = solution.contact.lambda;
  std::vector<const FrictionRow*> slides(static_cast<std::size_t>(p.b.size()), nullptr);
  for (const FrictionRow& f : problem.friction) {
    for (const int t : {f.tangent, f.second}) {
      if (t >= 0 && solution.touch[at(f.normal)] == SlipState::forward) {
        slides[at(t)] = &f;
      }
    }
  }
  std::vector<int> rows;
  std::vector<Eigen::Index> place(static_cast<std::size_t>(p.b.size()), -1);
  for (std::size_t i = 0; i < slides.size(); ++i) {
    if (solution.contact.closed[i]) {
      place[i] = index(rows.size());
      rows.push_back(static_cast<int>(i));
    }
  }
  const auto n = index(rows.size());
  const Eigen::Index m = p.B.cols();
  base::Matrix J = base::Matrix::Zero(n + m, n + m);
  const double motion = p.B.size() > 0 ? p.B.cwiseAbs().maxCoeff() : 1.0;
  const double size = n > 0 ? p.W.diagonal().maxCoeff() : 1.0;
  const auto add_gap = [&](Eigen::Index r, int i, double factor) {
    for (Eigen::Index c = 0; c < n; ++c) {
      J(r, c) += factor * p.W(i, rows[at(c)]) / size;
    }
    J.row(r).tail(m) += factor * p.B.row(i) / motion;
  };
  for (Eigen::Index r = 0; r < n; ++r) {
    const int i = rows[at(r)];
    J.col(r).tail(m) = p.B.row(i).transpose() / motion;
    const FrictionRow* const f = slides[at(i)];
    if (f == nullptr) {
      add_gap(r, i, 1.0);
      continue;
    }
    // The shear against the slip v, turning with it: q + mu p v/|v| = 0.
    Eigen::Vector2d v(solution.contact.gap[f->tangent], 0.0);
    v[1] = f->second >= 0 ? solution.contact.gap[f->second] : 0.0;
    const double speed = v.norm();
    const auto own = static_cast<Eigen::Index>(i == f->tangent ? 0 : 1);
    J(r, r) += 1.0;
    if (speed > 0.0) {
      const Eigen::Vector2d along = v / speed;
      J(r, place[at(f->normal)]) += share * f->mu * along[own];
      const double turn = share * f->mu * std::max(lambda[f->normal], 0.0) / speed * size;
      for (Eigen::Index k = 0; f->second >= 0 && k < 2; ++k) {
        const double across = (k == own ? 1.0 : 0.0) - along[own] * along[k];
        add_gap(r, k == 0 ? f->tangent : f->second, turn * across);
      }
    }
  }
  return J;
}

} // namespace

bool has_other_solutions(const FrictionProblem& problem, const FrictionSolution& solution) {
  if (has_round_cones(problem.friction)) {
    const int with = determinant_sign(round_jacobian(problem, solution, 1.0));
    return with * determinant_sign(round_jacobian(problem, solution, 0.0)) < 0;
  }
  const std::vector<bool>& closed = solution.contact.closed;
  const std::vector<SlipState>& touch = solution.touch;
  const std::size_t n = closed.size();
  std::vector<double> ratio(n, 0.0);
  std::vector<int> tangent(n, -1);
  std::vector<bool> slides(n, false);
  bool any = false;
  for (const FrictionRow& f : problem.friction) {
    const auto row = static_cast<std::size_t>(f.normal);
    const SlipState state = touch[row];
    if (closed[row] && (state == SlipState::forward || state == SlipState::backward)) {
      ratio[row] = state == SlipState::forward ? -f.mu : f.mu;
      any = true;
    }
    tangent[row] = f.tangent;
    // Tangents of sliding and open rows have no equation of their own: their shear follows or is
    // zero.
    slides[at(f.tangent)] = state != SlipState::stick || !closed[row];
  }
  if (!any) {
    return false;
  }
  std::vector<int> rows;
  for (std::size_t i = 0; i < n; ++i) {
    if (closed[i] && !slides[i]) {
      rows.push_back(static_cast<int>(i));
    }
  }
  const int with = determinant_sign(jacobian(problem, rows, ratio, tangent));
  // The same rows, so that friction alone makes the difference (solve.34).
  const int without =
      determinant_sign(jacobian(problem, rows, std::vector<double>(n, 0.0), tangent));
  return with * without < 0;
}

} // namespace spricka::solve
