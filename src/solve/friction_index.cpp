// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/friction_index.hpp"
#include "base/index.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace spricka::solve {

using base::at;
using base::index;

namespace {

constexpr double singular = 1e-11; ///< a pivot below this part of the largest tells nothing

/// Sign of a determinant; 0 where round-off could have made it.
int determinant_sign(const base::Matrix& J) {
  if (J.rows() == 0) {
    return 1;
  }
  const Eigen::PartialPivLU<base::Matrix> lu(J);
  const base::Vector pivots = lu.matrixLU().diagonal();
  if (!(pivots.cwiseAbs().minCoeff() > singular * pivots.cwiseAbs().maxCoeff())) {
    return 0;
  }
  const auto negative = (pivots.array() < 0.0).count();
  const int order = lu.permutationP().determinant() < 0 ? -1 : 1;
  return negative % 2 == 0 ? order : -order;
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

} // namespace

bool one_of_several(const FrictionProblem& problem, const std::vector<bool>& closed,
                    const std::vector<Touch>& touch) {
  const std::size_t n = closed.size();
  std::vector<double> ratio(n, 0.0);
  std::vector<int> tangent(n, -1);
  std::vector<bool> slides(n, false);
  bool any = false;
  for (const FrictionRow& f : problem.friction) {
    const auto row = static_cast<std::size_t>(f.normal);
    const Touch state = touch[row];
    if (closed[row] && (state == Touch::forward || state == Touch::backward)) {
      ratio[row] = state == Touch::forward ? -f.mu : f.mu;
      any = true;
    }
    tangent[row] = f.tangent;
    // Tangents of sliding and open rows have no equation of their own: their shear follows or is
    // zero.
    slides[at(f.tangent)] = state != Touch::stick || !closed[row];
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
