// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/layered_cholesky.hpp"
#include "base/index.hpp"

#include <utility>

namespace spricka::solve {

using base::index;

EarlyRows::EarlyRows(const base::Matrix& A, EarlyLists lists)
    : lists_(std::move(lists)), L_(A(lists_.early, lists_.early)),
      X_(A(lists_.early, lists_.late)) {
  if (L_.ok()) {
    X_ = L_.half_solve(std::move(X_));
    // Not factorised here: other elements are added to it first, and alone it may be singular.
    schur_ = A(lists_.late, lists_.late) - gram(X_);
  }
}

base::Matrix EarlyRows::half_solve(base::Matrix B) const {
  return L_.half_solve(std::move(B));
}

base::Matrix EarlyRows::late_load(const base::Matrix& Y) const {
  return product(X_, Y);
}

base::Matrix EarlyRows::finish(base::Matrix Y, const base::Matrix& U) const {
  Y.noalias() -= X_ * U;
  return L_.half_solve_transposed(std::move(Y));
}

LayeredCholesky::LayeredCholesky(std::shared_ptr<const EarlyRows> early,
                                 std::vector<Eigen::Index> place, base::Matrix D)
    : early_(std::move(early)), place_(std::move(place)), late_(std::move(D)) {}

base::Matrix LayeredCholesky::late_half(const base::Matrix& late_load) const {
  base::Matrix B = base::Matrix::Zero(late_.size(), late_load.cols());
  for (std::size_t i = 0; i < place_.size(); ++i) {
    // What elimination of the early rows takes off rows of D that have no load of their own.
    B.row(place_[i]) = -late_load.row(index(i));
  }
  return late_.half_solve(std::move(B));
}

base::Matrix LayeredCholesky::half_solve(const base::Matrix& B) const {
  base::Matrix Y(size(), B.cols());
  const base::Matrix first = early_->half_solve(B.topRows(early_rows()));
  base::Matrix rest = B.bottomRows(late_.size());
  const base::Matrix late_load = early_->late_load(first);
  for (std::size_t i = 0; i < place_.size(); ++i) {
    // Only the late rows of the block feel the early ones; other rows of D do not.
    rest.row(place_[i]) -= late_load.row(index(i));
  }
  Y.topRows(early_rows()) = first;
  Y.bottomRows(late_.size()) = late_.half_solve(std::move(rest));
  return Y;
}

base::Matrix LayeredCholesky::solve(const base::Matrix& B) const {
  base::Matrix Y = half_solve(B);
  // From the last rows up: the early rows follow from those of the late ones that they touch.
  const base::Matrix late = late_.half_solve_transposed(Y.bottomRows(late_.size()));
  base::Matrix U(index(place_.size()), B.cols());
  for (std::size_t i = 0; i < place_.size(); ++i) {
    U.row(index(i)) = late.row(place_[i]);
  }
  const base::Matrix first = early_->finish(Y.topRows(early_rows()), U);
  Y.topRows(early_rows()) = first;
  Y.bottomRows(late_.size()) = late;
  return Y;
}

} // namespace spricka::solve
