// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/stress_patch.hpp"

#include "base/by_dimension.hpp"
#include "base/with_dimension.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace spricka::fe {

namespace {

// Samples spread by less than this part of their elements, root mean square, lie in one layer that
// is bent at most; two layers of middles have 0.5, the two points across one layer 0.29.
constexpr double least_spread = 0.15;
// Part of a term's square that earlier terms must leave over.
constexpr double least_share = 0.02;

constexpr int term_count(int dim, int degree) {
  return degree == 0 ? 1 : (degree == 1 ? dim + 1 : (dim + 1) * (dim + 2) / 2);
}

Eigen::Matrix3d principal_in_plane(const Eigen::Matrix3d& spread) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(Eigen::Matrix2d(spread.topLeftCorner<2, 2>()));
  Eigen::Matrix3d directions = Eigen::Matrix3d::Zero();
  directions.topLeftCorner<2, 2>() = solver.eigenvectors();
  return directions;
}
Eigen::Matrix3d principal_in_space(const Eigen::Matrix3d& spread) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors();
}
// Principal directions of the spread of samples, columns.
constexpr base::ByDimension principal_directions{&principal_in_plane, &principal_in_space};

} // namespace

FittedStressPolynomial::FittedStressPolynomial(std::span<const StressSample* const> samples,
                                               int dim, int degree)
    : dim_(dim), count_(term_count(dim, degree)) {
  // About their centre and in units of their spread samples leave well conditioned equations on
  // stretched elements as well.
  choose_axes(samples);
  base::with_dimension(dim, [&](auto known) { fit<known>(samples); });
}

void FittedStressPolynomial::choose_axes(std::span<const StressSample* const> samples) {
  const double share = 1.0 / static_cast<double>(samples.size());
  for (const StressSample* s : samples) {
    centre_ += share * s->x;
  }
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const StressSample* s : samples) {
    spread += share * (s->x - centre_) * (s->x - centre_).transpose();
  }
  double longest = 0.0; // mean
  for (const StressSample* s : samples) {
    longest += share * s->longest;
  }
  // Whether samples spread enough for the mean width of their elements along an axis; mostly they
  // do for the largest width that there could be.
  const auto is_wide = [&](const base::Vec3& axis, double spread_along) {
    if (spread_along > least_spread * longest) {
      return true;
    }
    double extent = 0.0;
    for (const StressSample* s : samples) {
      extent += share * (s->extent.transpose() * axis).lpNorm<1>();
    }
    return spread_along > least_spread * extent;
  };
  // An axis along which the samples spread too little stays zero, and with it all terms in it.
  const auto along = [&](const base::Vec3& axis, double square, int row) {
    if (square > 0.0 && is_wide(axis, std::sqrt(square))) {
      axes_.row(row) = axis.transpose() / std::sqrt(square);
    }
  };
  const Eigen::Matrix3d directions = principal_directions.at(dim_)(spread);
  for (int i = 0; i < dim_; ++i) {
    const base::Vec3 axis = directions.col(i);
    along(axis, axis.dot(spread * axis), i);
  }
}

template <int dim>
FittedStressPolynomial::Terms FittedStressPolynomial::terms(const base::Vec3& x) const {
  const base::Vec3 d = axes_ * (x - centre_);
  Terms t = Terms::Zero();
  int k = 0;
  t[k++] = 1.0;
  for (int i = 0; i < dim; ++i) {
    t[k++] = d[i];
  }
  for (int i = 0; i < dim * (dim - 1) / 2; ++i) {
    t[k++] = d[i] * d[(i + 1) % dim];
  }
  for (int i = 0; i < dim; ++i) {
    t[k++] = d[i] * d[i];
  }
  return t;
}

// Normal equations by Cholesky's method in the order of the terms.
template <int dim> void FittedStressPolynomial::fit(std::span<const StressSample* const> samples) {
  constexpr int some = term_count(dim, 2); // no degree has more
  Eigen::Matrix<double, some, some> A = Eigen::Matrix<double, some, some>::Zero();
  Eigen::Matrix<double, some, 6> b = Eigen::Matrix<double, some, 6>::Zero();
  for (const StressSample* s : samples) {
    const Eigen::Matrix<double, some, 1> t = terms<dim>(s->x).template head<some>();
    A.noalias() += t * t.transpose();
    b.noalias() += t * s->stress.transpose();
  }
  // The squares of the terms, before earlier ones take their parts.
  const Eigen::Matrix<double, some, 1> own = A.diagonal();
  std::array<bool, some> used{};
  std::size_t left = samples.size(); // no more terms than samples
  for (int k = 0; k < count_; ++k) {
    const bool carried = left > 0 && own[k] > 0.0 && A(k, k) > least_share * own[k];
    used[static_cast<std::size_t>(k)] = carried;
    complete_ = complete_ && carried;
    if (!carried) {
      continue;
    }
    --left;
    for (int i = k + 1; i < count_; ++i) {
      const double factor = A(i, k) / A(k, k);
      A.row(i).segment(k, count_ - k) -= factor * A.row(k).segment(k, count_ - k);
      b.row(i) -= factor * b.row(k);
    }
  }
  for (int k = count_ - 1; k >= 0; --k) {
    if (!used[static_cast<std::size_t>(k)]) {
      continue;
    }
    coefficient_.col(k) = b.row(k).transpose();
    for (int i = k + 1; i < count_; ++i) {
      coefficient_.col(k) -= A(k, i) * coefficient_.col(i);
    }
    coefficient_.col(k) /= A(k, k);
  }
}

Stress FittedStressPolynomial::at(const base::Vec3& x) const {
  return base::with_dimension(dim_, [&](auto known) {
    constexpr int count = term_count(known, 2);
    const Terms t = terms<known>(x); // coefficients are zero where no term is
    return Stress(coefficient_.leftCols<count>() * t.head<count>());
  });
}

} // namespace spricka::fe
