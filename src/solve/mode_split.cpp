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

/// As many rows of U [k, r] as it has columns, those that tell its columns apart best (full
/// pivoting), the last of equals.
std::vector<bool> pivot_rows(base::Matrix U) {
  std::vector<bool> taken(static_cast<std::size_t>(U.rows()), false);
  for (Eigen::Index c = 0; c < U.cols(); ++c) {
    Eigen::Index row = -1;
    Eigen::Index col = -1;
    double most = 0.0;
    for (Eigen::Index i = 0; i < U.rows(); ++i) {
      for (Eigen::Index j = 0; j < U.cols(); ++j) {
        if (!taken[at(i)] && std::abs(U(i, j)) >= most * (1.0 - 1e-6)) {
          most = std::max(most, std::abs(U(i, j)));
          row = i;
          col = j;
        }
      }
    }
    taken[at(row)] = true;
    const base::Vector pivot = U.col(col) / U(row, col);
    for (Eigen::Index j = 0; j < U.cols(); ++j) {
      U.col(j) -= U(row, j) * pivot;
    }
    U.col(col).setZero();
  }
  return taken;
}

} // namespace

ModeSplit split_modes(const base::Matrix& B, double opening_scale) {
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
      // Beside them stand the given modes themselves: what a load on an uncontrollable one leaves
      // over is then a load on modes left out here, a couple but no force if those are rotations.
      const std::vector<bool> out = pivot_rows(orthonormal(scale * V.rightCols(k - rank)));
      controllable = base::Matrix(m, rank);
      Eigen::Index to = 0;
      for (Eigen::Index c = 0; c < k; ++c) {
        const Eigen::Index j = touched[at(c)];
        if (!out[at(j)]) {
          controllable.col(to++) = scale.col(c);
        }
      }
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
