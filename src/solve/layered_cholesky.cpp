// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/layered_cholesky.hpp"
#include "base/index.hpp"

#include <utility>

namespace spricka::solve {

using base::index;

FirstBlockFactor::FirstBlockFactor(const base::Matrix& A, EarlyLateRowPartition lists)
    : lists_(std::move(lists)), L_(A(lists_.early, lists_.early)),
      X_(A(lists_.early, lists_.late)) {
  if (L_.is_positive_definite()) {
    X_ = L_.forward_substitute(std::move(X_));
    // Not factorised here: other elements are added to it first, and alone it may be singular.
    schur_ = A(lists_.late, lists_.late) - gram_matrix(X_);
  }
}

base::Matrix FirstBlockFactor::forward_substitute(base::Matrix B) const {
  return L_.forward_substitute(std::move(B));
}

base::Matrix FirstBlockFactor::second_block_load_reduction(const base::Matrix& Y) const {
  return transposed_product(X_, Y);
}

base::Matrix FirstBlockFactor::solve_first_block(base::Matrix Y, const base::Matrix& U) const {
  Y.noalias() -= X_ * U;
  return L_.backward_substitute(std::move(Y));
}

TwoBlockCholesky::TwoBlockCholesky(std::shared_ptr<const FirstBlockFactor> early,
                                   std::vector<Eigen::Index> place, base::Matrix D)
    : early_(std::move(early)), place_(std::move(place)), late_(std::move(D)) {}

base::Matrix TwoBlockCholesky::forward_second_block(const base::Matrix& late_load) const {
  base::Matrix B = base::Matrix::Zero(late_.size(), late_load.cols());
  for (std::size_t i = 0; i < place_.size(); ++i) {
    // What elimination of the early rows takes off rows of D that have no load of their own.
    B.row(place_[i]) = -late_load.row(index(i));
  }
  return late_.forward_substitute(std::move(B));
}

base::Matrix TwoBlockCholesky::forward_substitute(const base::Matrix& B) const {
  base::Matrix Y(size(), B.cols());
  const base::Matrix first = early_->forward_substitute(B.topRows(first_block_size()));
  base::Matrix rest = B.bottomRows(late_.size());
  const base::Matrix late_load = early_->second_block_load_reduction(first);
  for (std::size_t i = 0; i < place_.size(); ++i) {
    // Only the late rows of the block feel the early ones; other rows of D do not.
    rest.row(place_[i]) -= late_load.row(index(i));
  }
  Y.topRows(first_block_size()) = first;
  Y.bottomRows(late_.size()) = late_.forward_substitute(std::move(rest));
  return Y;
}

base::Matrix TwoBlockCholesky::solve(const base::Matrix& B) const {
  base::Matrix Y = forward_substitute(B);
  // From the last rows up: the early rows follow from those of the late ones that they touch.
  const base::Matrix late = late_.backward_substitute(Y.bottomRows(late_.size()));
  base::Matrix U(index(place_.size()), B.cols());
  for (std::size_t i = 0; i < place_.size(); ++i) {
    U.row(index(i)) = late.row(place_[i]);
  }
  const base::Matrix first = early_->solve_first_block(Y.topRows(first_block_size()), U);
  Y.topRows(first_block_size()) = first;
  Y.bottomRows(late_.size()) = late;
  return Y;
}

} // namespace spricka::solve
