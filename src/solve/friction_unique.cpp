// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/friction_unique.hpp"
#include "base/dense_solve.hpp"
#include "base/index.hpp"
#include "solve/blas.hpp"
#include "solve/friction_set.hpp"
#include "solve/mode_split.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace spricka::solve {

using base::at;
using base::index;

namespace {

/// Weights of the test: how |v_i| and |pressure_i| share their product, and how much of the
/// complementarity of pressure and opening is added. Any will do; good ones prove more.
struct Weights {
  base::Vector share;    ///< [unit] kappa
  base::Vector openings; ///< [unit] a
};

/// Orthonormal motions of rows when bodies move rigidly, equality rows kept [k, z].
base::Matrix rigid_openings(const ScaledFrictionProblem& problem, const std::vector<int>& rows) {
  const int m = problem.mode_count();
  if (m == 0) {
    return base::Matrix::Zero(index(rows.size()), 0);
  }
  base::Matrix free = base::Matrix::Identity(m, m);
  if (!problem.fixed.empty()) {
    base::Matrix B_T(m, index(problem.fixed.size()));
    for (std::size_t k = 0; k < problem.fixed.size(); ++k) {
      B_T.col(index(k)) = problem.B.row(problem.fixed[k]).transpose();
    }
    free = base::orthogonal_complement(B_T, 1e-9); // motions that open no equality row
  }
  base::Matrix moved(index(rows.size()), free.cols());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    moved.row(index(r)) = problem.B.row(rows[r]) * free;
  }
  if (moved.size() == 0) {
    return moved;
  }
  const base::SingularVectors svd = base::left_singular_vectors(moved);
  const Eigen::Index rank = (svd.values.array() > 1e-9 * svd.values(0)).count();
  return svd.vectors.leftCols(rank);
}

/// Whether the form of (solve.27) is positive definite across the rigid motions N.
bool positive(const ScaledFrictionProblem& problem, const InterfaceStiffness& face,
              const Weights& weights, const base::Matrix& N) {
  const Eigen::Index units = index(problem.units.size());
  base::Matrix F = face.A;
  F.topRows(units) += 0.5 * (weights.openings.asDiagonal() * face.A.topRows(units));
  F.leftCols(units) += 0.5 * (face.A.leftCols(units) * weights.openings.asDiagonal());
  // The term A_n^T mu / (2 kappa) A_n is the product of this matrix with itself.
  base::Matrix pressure = face.A.topRows(units); // of the units with friction, weighted
  Eigen::Index tangent = units;
  for (Eigen::Index i = 0; i < units; ++i) {
    const ScaledFrictionProblem::FrictionUnit& u = problem.units[at(i)];
    const double kappa = weights.share(i);
    pressure.row(i) *= u.tangent >= 0 ? std::sqrt(0.5 * u.mu / kappa) : 0.0;
    if (u.tangent >= 0) {
      F(tangent, tangent) -= 0.5 * u.mu * kappa;
      ++tangent;
    }
  }
  const int k = static_cast<int>(F.rows());
  const int m = static_cast<int>(units);
  blas::gemm(
      {.m = k, .n = k, .k = m, .a = blas::Transposition::transposed, .alpha = -1.0, .beta = 1.0},
      {pressure.data(), m}, {pressure.data(), m}, {F.data(), k});
  if (N.cols() > 0) {
    // Rigid motions are left out of the test: made so stiff that the form is positive along them.
    F += 1e4 * face.A.diagonal().maxCoeff() * (N * N.transpose());
  }
  // A margin above round-off: what is positive by less than that is not called so.
  F.diagonal().array() -= 1e-9 * face.A.diagonal().array();
  return blas::cholesky(k, {F.data(), k});
}

Weights weights_of(const ScaledFrictionProblem& problem, const InterfaceStiffness& face,
                   double share, double openings) {
  const Eigen::Index units = index(problem.units.size());
  Weights w{base::Vector::Ones(units), base::Vector::Constant(units, openings)};
  Eigen::Index tangent = units;
  for (Eigen::Index i = 0; i < units; ++i) {
    const ScaledFrictionProblem::FrictionUnit& u = problem.units[at(i)];
    if (u.tangent < 0) {
      continue;
    }
    const double own = face.A(tangent, tangent);
    if (share > 0.0) {
      w.share(i) = share * own;
    } else { // exact for a row by itself
      w.share(i) = std::max(std::abs(face.A(i, tangent)), 0.05 * own);
      w.openings(i) = std::max(u.mu * face.A(i, i) / w.share(i) - 2.0, 0.0);
    }
    ++tangent;
  }
  return w;
}

} // namespace

UniquenessResult check_uniqueness(const FrictionProblem& problem) {
  blas::force_single_blas_thread();
  UniquenessResult found;
  const ModeSplit split =
      split_controllable_modes(problem.contact.B, problem.contact.opening_scale);
  const ControllableProblem held = restrict_to_controllable_modes(problem.contact, split);
  const ScaledFrictionProblem scaled =
      scale_friction_problem(held, problem.friction, problem.contact.load_scale);
  const bool rubs = std::any_of(scaled.units.begin(), scaled.units.end(),
                                [](const auto& u) { return u.tangent >= 0; });
  if (!rubs) {
    found = {true, scaled.mode_count() > 0};
    return found;
  }
  const InterfaceStiffness face =
      interface_stiffness(scaled, base::Vector::Zero(scaled.mode_count()));
  if (!face.regular) {
    return found;
  }
  const base::Matrix N = rigid_openings(scaled, face.rows);
  found.apart_from_motions = N.cols() > 0;
  constexpr std::array<std::array<double, 2>, 7> trials{
      {{0.5, 0.0}, {0.0, 0.0}, {1.0, 0.0}, {0.5, 1.0}, {1.0, 1.0}, {0.25, 2.0}, {0.5, 4.0}}};
  // where a trial takes as long as an increment the two best must do
  const std::size_t count = face.rows.size() > 1500 ? 2 : trials.size();
  for (const auto& [share, openings] : std::span(trials).first(count)) {
    if (positive(scaled, face, weights_of(scaled, face, share, openings), N)) {
      found.certain = true;
      break;
    }
  }
  return found;
}

} // namespace spricka::solve
