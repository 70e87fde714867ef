// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/mode_split.hpp"
#include "base/dense_solve.hpp"
#include "base/index.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace spricka::solve {

using base::at;
using base::index;

namespace {

constexpr double dependent = 1e-9; ///< of the largest singular value

base::Matrix orthonormal(const base::Matrix& A) {
  if (A.cols() == 0) {
    return A;
  }
  const Eigen::HouseholderQR<base::Matrix> qr(A);
  return qr.householderQ() * base::Matrix::Identity(A.rows(), A.cols());
}

/// Right singular vectors of A [n, k] and its singular values, through R of a QR.
struct RightVectors {
  base::Matrix V; ///< [k, k]
  base::Vector s; ///< [k], zeros where n < k
};

RightVectors right_vectors(const base::Matrix& A) {
  const Eigen::Index k = A.cols();
  base::Matrix R = base::Matrix::Zero(k, k);
  const Eigen::HouseholderQR<base::Matrix> qr(A);
  const Eigen::Index top = std::min(A.rows(), k);
  R.topRows(top) = base::Matrix(qr.matrixQR().topRows(top)).triangularView<Eigen::Upper>();
  const base::SingularVectors svd = base::right_singular_vectors(R);
  return {svd.vectors, svd.values};
}

/// Orthonormal directions across the columns of A [m, k], which are independent.
base::Matrix across(const base::Matrix& A) {
  const Eigen::HouseholderQR<base::Matrix> qr(A);
  const base::Matrix Q = qr.householderQ() * base::Matrix::Identity(A.rows(), A.rows());
  return Q.rightCols(A.rows() - A.cols());
}

} // namespace

ModeSplit split_controllable_modes(const base::Matrix& B, double opening_scale) {
  const Eigen::Index m = B.cols();
  const double largest = B.size() == 0 ? 0.0 : B.cwiseAbs().maxCoeff();
  const double floor = uncontrollable_opening * (opening_scale > 0.0 ? opening_scale : largest);
  std::vector<Eigen::Index> touched;
  base::Matrix uncontrollable(m, 0);
  const auto add_uncontrollable = [&uncontrollable](const base::Vector& direction) {
    uncontrollable.conservativeResize(Eigen::NoChange, uncontrollable.cols() + 1);
    uncontrollable.rightCols(1) = direction;
  };
  for (Eigen::Index j = 0; j < m; ++j) {
    if (B.rows() > 0 && B.col(j).cwiseAbs().maxCoeff() > floor) {
      touched.push_back(j);
    } else {
      add_uncontrollable(base::Vector::Unit(m, j));
    }
  }
  const Eigen::Index k = index(touched.size());
  base::Matrix scale = base::Matrix::Zero(m, k);
  for (Eigen::Index c = 0; c < k; ++c) {
    const Eigen::Index j = touched[at(c)];
    scale(j, c) = 1.0 / B.col(j).cwiseAbs().maxCoeff();
  }
  base::Matrix controllable = scale;
  if (k > 0) {
    const auto [V, s] = right_vectors(B * scale);
    Eigen::Index rank = (s.array() > dependent * s(0)).count();
    // a column as small as the floor is scaled up with its round-off: what a unit motion opens
    // tells
    while (rank > 0 && (B * (scale * V.col(rank - 1))).cwiseAbs().maxCoeff() <=
                           floor * (scale * V.col(rank - 1)).norm()) {
      --rank;
    }
    if (rank < k) {
      for (Eigen::Index c = rank; c < k; ++c) {
        add_uncontrollable(scale * V.col(c));
      }
      // Across them, so that what a load on them leaves over is a load on them alone: were given
      // modes to stand beside them, it would be one on those left out, such as a force.
      controllable = across(uncontrollable);
    }
    for (Eigen::Index c = 0; c < rank; ++c) {
      controllable.col(c) /= (B * controllable.col(c)).cwiseAbs().maxCoeff();
    }
  }
  return {controllable, orthonormal(uncontrollable)};
}

base::Vector uncontrollable_motion(const ModeSplit& split, const base::Vector& h, double least) {
  const base::Vector load = split.uncontrollable.transpose() * h;
  if (load.size() == 0 || !(load.cwiseAbs().maxCoeff() > least)) {
    return {};
  }
  return (split.uncontrollable * load).normalized();
}

} // namespace spricka::solve
