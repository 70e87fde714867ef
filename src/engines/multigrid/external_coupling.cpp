// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/multigrid/external_coupling.hpp"
#include "base/index.hpp"

namespace spricka::engines {

using base::at;
using base::index;

ExternalCoupling::ExternalCoupling(const base::SymmetricCsc& K, std::int64_t locals)
    : K_ee_(base::Matrix::Zero(index(K.n - locals), index(K.n - locals))) {
  for (std::int64_t j = 0; j < K.n; ++j) {
    for (std::int64_t p = K.start[at(j)]; p < K.start[at(j) + 1]; ++p) {
      const std::int64_t row = K.row[at(p)] - locals;
      if (row < 0) {
        continue;
      }
      if (j < locals) {
        external_.push_back(row);
        value_.push_back(K.value[at(p)]);
      } else {
        K_ee_(row, j - locals) = K.value[at(p)];
        K_ee_(j - locals, row) = K.value[at(p)];
      }
    }
    if (j < locals) {
      start_.push_back(static_cast<std::int64_t>(external_.size()));
    }
  }
}

base::Vector ExternalCoupling::forces_on_externals(const base::Vector& u) const {
  base::Vector forces = base::Vector::Zero(K_ee_.rows());
  for (std::size_t j = 0; j + 1 < start_.size(); ++j) {
    for (std::int64_t p = start_[j]; p < start_[j + 1]; ++p) {
      forces[external_[at(p)]] += value_[at(p)] * u[index(j)];
    }
  }
  return forces;
}

base::Vector ExternalCoupling::forces_on_locals(const base::Vector& u) const {
  base::Vector forces = base::Vector::Zero(index(start_.size()) - 1);
  for (std::size_t j = 0; j + 1 < start_.size(); ++j) {
    for (std::int64_t p = start_[j]; p < start_[j + 1]; ++p) {
      forces[index(j)] += value_[at(p)] * u[external_[at(p)]];
    }
  }
  return forces;
}

void ExternalCoupling::append_column(std::int64_t local, std::vector<std::int64_t>& rows,
                                     std::vector<double>& values) const {
  const auto locals = static_cast<std::int64_t>(start_.size()) - 1;
  for (std::int64_t p = start_[at(local)]; p < start_[at(local) + 1]; ++p) {
    rows.push_back(locals + external_[at(p)]);
    values.push_back(value_[at(p)]);
  }
}

} // namespace spricka::engines
