// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/mumps/mumps_matrix.hpp"
#include "base/index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace spricka::engines {

using base::at;

namespace {

// The power of two next to 1 / sqrt(diagonal). What is not positive stays as it is: its pivot will
// tell.
double scale_for(double diagonal) {
  if (!(diagonal > 0.0) || !std::isfinite(diagonal)) {
    return 1.0;
  }
  return std::exp2(-std::round(0.5 * std::log2(diagonal)));
}

} // namespace

MumpsMatrix::MumpsMatrix(base::SymmetricCsc& K, std::int64_t locals)
    : locals_(locals), scale_(at(K.n), 1.0) {
  for (std::int64_t j = 0; j < locals; ++j) {
    scale_[at(j)] = scale_for(K.value[at(K.start[at(j)])]);
  }
  row_.reserve(K.row.size());
  column_.reserve(K.row.size());
  for (std::int64_t j = 0; j < K.n; ++j) {
    for (std::int64_t p = K.start[at(j)]; p < K.start[at(j) + 1]; ++p) {
      const std::int64_t i = K.row[at(p)];
      row_.push_back(static_cast<int>(i + 1));
      column_.push_back(static_cast<int>(j + 1));
      K.value[at(p)] *= scale_[at(i)] * scale_[at(j)];
    }
  }
  start_ = std::move(K.start);
  value_ = std::move(K.value);
  K = base::SymmetricCsc();
}

void MumpsMatrix::apply_scale(base::Matrix& X) const {
  for (std::int64_t i = 0; i < locals_; ++i) {
    X.row(i) *= scale_[at(i)];
  }
}

MumpsMatrix::Residual MumpsMatrix::residual_of(const base::Matrix& u, const base::Matrix& f) const {
  Residual residual{f, 0.0};
  const Eigen::Index n = f.rows();
  base::Vector terms(n); // of a column: |K| |u| + |f|
  for (Eigen::Index k = 0; k < f.cols(); ++k) {
    auto r = residual.value.col(k);
    terms = f.col(k).cwiseAbs();
    for (Eigen::Index j = 0; j < n; ++j) {
      for (std::int64_t p = start_[at(j)]; p < start_[at(j + 1)]; ++p) {
        const Eigen::Index i = row_[at(p)] - 1;
        const double lower = value_[at(p)] * u(j, k);
        r[i] -= lower;
        terms[i] += std::abs(lower);
        if (i != j) {
          const double upper = value_[at(p)] * u(i, k);
          r[j] -= upper;
          terms[j] += std::abs(upper);
        }
      }
    }
    r.tail(n - locals_).setZero();
    for (Eigen::Index i = 0; i < locals_; ++i) {
      const double share = terms[i] == 0.0 ? 0.0 : std::abs(r[i]) / terms[i];
      residual.backward_error = std::isnan(share) ? std::numeric_limits<double>::infinity()
                                                  : std::max(residual.backward_error, share);
    }
  }
  return residual;
}

base::SymmetricCsc MumpsMatrix::give_back() {
  base::SymmetricCsc K;
  K.n = size();
  K.row.reserve(row_.size());
  for (std::int64_t j = 0; j < K.n; ++j) {
    for (std::int64_t p = start_[at(j)]; p < start_[at(j) + 1]; ++p) {
      const std::int64_t i = row_[at(p)] - 1;
      K.row.push_back(i);
      value_[at(p)] /= scale_[at(i)] * scale_[at(j)];
    }
  }
  K.start = std::exchange(start_, {});
  K.value = std::exchange(value_, {});
  row_ = {};
  column_ = {};
  return K;
}

} // namespace spricka::engines
