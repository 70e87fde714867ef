// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/condensed_body.hpp"

#include "base/index.hpp"

#include <utility>

#include <Eigen/LU>
#include <Eigen/QR>

namespace spricka::contact {

using base::at;
using base::index;

namespace {

base::Matrix orthonormal(const base::Matrix& modes) {
  if (modes.cols() == 0) {
    return modes;
  }
  // The thin Q: as many columns as modes, whatever basis they came in.
  const Eigen::HouseholderQR<base::Matrix> qr(modes);
  return qr.householderQ() * base::Matrix::Identity(modes.rows(), modes.cols());
}

// S with its null space filled; S is overwritten, as it may be large.
base::Matrix held(base::Matrix S, const base::Matrix& Q) {
  if (Q.cols() > 0) {
    const double mean = S.trace() / static_cast<double>(S.rows());
    const double k = mean > 0.0 ? mean : 1.0; // a body of rigid modes only: any number will do
    S.noalias() += k * Q * Q.transpose();
  }
  return S;
}

// Rows on unknowns as columns, each a sparse one.
solve::SparseRightHandSides as_sparse(const std::vector<std::vector<RowCoefficient>>& rows) {
  solve::SparseRightHandSides F;
  for (const std::vector<RowCoefficient>& row : rows) {
    for (const RowCoefficient& share : row) {
      F.row.push_back(share.at);
      F.value.push_back(share.weight);
    }
    F.start.push_back(static_cast<std::int64_t>(F.row.size()));
  }
  return F;
}

} // namespace

CondensedBody::CondensedBody(std::vector<std::int32_t> freedom, base::Matrix S,
                             const base::Matrix& modes)
    : freedom_(std::move(freedom)), Q_(orthonormal(modes)), factor_(held(std::move(S), Q_)) {}

CondensedBody::CondensedBody(std::vector<std::int32_t> freedom,
                             solve::FactoredSchurComplement factor)
    : freedom_(std::move(freedom)), Q_(index(freedom_.size()), 0), factor_(base::Matrix()),
      layered_(std::move(factor)) {}

// The part of F off the rigid modes, P F of (solve.10).
base::Matrix CondensedBody::project(base::Matrix F) const {
  if (Q_.cols() > 0) {
    F -= Q_ * (Q_.transpose() * F);
  }
  return F;
}

base::Matrix CondensedBody::compliance_root(const base::Matrix& F) const {
  // A layered factor has no modes to project off. Its early rows come first in Y.
  return layered_ ? layered_->L.forward_substitute(spread(F))
                  : factor_.forward_substitute(project(F));
}

base::Matrix CondensedBody::displacements_under_forces(const base::Matrix& F) const {
  if (is_uncondensed()) {
    base::Matrix u = response(off_modes(F));
    if (Q_.cols() > 0) {
      u -= Q_ * (Q_(whole_.weighed, Eigen::all).transpose() * u(whole_.weighed, Eigen::all));
    }
    return u;
  }
  if (!layered_) {
    return project(factor_.solve(project(F)));
  }
  const base::Matrix u = layered_->L.solve(spread(F));
  return u(layered_->row, Eigen::all);
}

base::Matrix CondensedBody::spread(const base::Matrix& F) const {
  base::Matrix all = base::Matrix::Zero(layered_->L.size(), F.cols());
  all(layered_->row, Eigen::all) = F;
  return all;
}

CondensedBody::CondensedBody(std::vector<std::int32_t> freedom, UncondensedBody whole,
                             const base::Matrix& modes)
    : freedom_(std::move(freedom)), Q_(modes), factor_(base::Matrix()), whole_(std::move(whole)) {
  base::Matrix S = whole_.factor.take_schur();
  held_modes_ = orthonormal(Q_.bottomRows(S.rows()));
  factor_ = solve::DenseCholesky(held(std::move(S), held_modes_));
  if (Q_.cols() > 0) {
    const base::Matrix weighed = Q_(whole_.weighed, Eigen::all);
    // The same combination of the modes on all unknowns: R^-1 of weighed = Q R.
    const Eigen::HouseholderQR<base::Matrix> qr(weighed);
    qr.matrixQR().topRows(Q_.cols()).triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(
        Q_);
  }
}

// What the externals that hold a whole body do under loads condensed to them.
base::Matrix CondensedBody::hold(const base::Matrix& load) const {
  const auto off = [&](base::Matrix F) {
    if (held_modes_.cols() > 0) {
      F -= held_modes_ * (held_modes_.transpose() * F);
    }
    return F;
  };
  return off(factor_.solve(off(load)));
}

// Of a whole body, with any rigid motion in it.
base::Matrix CondensedBody::response(const base::Matrix& F) const {
  return whole_.factor.solve(F, [&](const base::Matrix& load) { return hold(load); });
}

// Loads in balance: what is none is taken off by forces on what rows weigh (solve.37).
base::Matrix CondensedBody::off_modes(base::Matrix F) const {
  if (Q_.cols() > 0) {
    const base::Matrix resultant = Q_.transpose() * F;
    F(whole_.weighed, Eigen::all) -= Q_(whole_.weighed, Eigen::all) * resultant;
  }
  return F;
}

solve::RowCompliance
CondensedBody::compliance_with_externals_held(const std::vector<std::vector<RowCoefficient>>& rows,
                                              std::int64_t lasting,
                                              solve::LastingColumns* kept) const {
  solve::RowCompliance out =
      whole_.factor.compliance_with_externals_held(as_sparse(rows), lasting, kept);
  if (out.condensed.rows() > 0) {
    out.W.noalias() += out.condensed.transpose() * hold(out.condensed);
    out.W.triangularView<Eigen::StrictlyUpper>() = out.W.transpose();
  }
  if (Q_.cols() == 0) {
    return out;
  }
  // W of rows whose forces are in balance, by what their resultants B do (solve.38).
  base::Matrix N = base::Matrix::Zero(Q_.rows(), Q_.cols());
  N(whole_.weighed, Eigen::all) = Q_(whole_.weighed, Eigen::all);
  const base::Matrix V = response(N);
  base::Matrix B = base::Matrix::Zero(index(rows.size()), Q_.cols());
  base::Matrix C = B;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (const RowCoefficient& share : rows[r]) {
      B.row(index(r)) += share.weight * Q_.row(share.at);
      C.row(index(r)) += share.weight * V.row(share.at);
    }
  }
  C -= 0.5 * B * (N.transpose() * V);
  out.W.noalias() -= B * C.transpose();
  out.W.noalias() -= C * B.transpose();
  out.W.triangularView<Eigen::StrictlyUpper>() = out.W.transpose();
  return out;
}

} // namespace spricka::contact
