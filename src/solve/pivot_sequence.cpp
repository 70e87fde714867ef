// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/pivot_sequence.hpp"
#include "base/index.hpp"
#include "solve/blas.hpp"

#include <algorithm>
#include <utility>

#include <Eigen/LU>

namespace spricka::solve {

using base::at;
using base::index;

void PivotSequence::clear(Eigen::Index size) {
  list_.clear();
  block_ = {.sound = true, .rows = {}, .columns = base::Matrix(size, 0), .core = {}};
}

void PivotSequence::append(std::vector<int> rows, base::Matrix columns) {
  PrincipalPivot pivot{std::move(rows), std::move(columns), {}};
  const auto p = index(pivot.rows.size());
  base::Matrix core(p, p);
  for (Eigen::Index r = 0; r < p; ++r) {
    core.row(r) = pivot.columns.row(pivot.rows[at(r)]);
  }
  pivot.inverse = core.inverse();
  add_to_block(pivot);
  list_.push_back(std::move(pivot));
}

void PivotSequence::add_to_block(const PrincipalPivot& pivot) {
  const int i = pivot.rows[0];
  block_.sound = block_.sound && pivot.rows.size() == 1 &&
                 std::find(block_.rows.begin(), block_.rows.end(), i) == block_.rows.end();
  if (!block_.sound) {
    return;
  }
  const auto l = index(block_.rows.size());
  if (l == block_.columns.cols()) {
    // Room doubles, so that columns are copied seldom.
    const Eigen::Index more = 2 * l + 64;
    block_.columns.conservativeResize(Eigen::NoChange, more);
    block_.core.conservativeResize(more, more);
  }
  // From here on row i holds -s of this pivot. What earlier columns have in it is used once, to
  // find this s, and is then cleared: apply_all_pivots() must not subtract it again.
  block_.core.row(l).head(l) = block_.columns.row(i).head(l);
  block_.core(l, l) = pivot.columns(i, 0);
  block_.columns.row(i).head(l).setZero();
  block_.columns.col(l) = pivot.columns.col(0);
  block_.columns(i, l) = 0.0;
  block_.rows.push_back(i);
}

void PivotSequence::apply_all_pivots(base::Matrix& columns) const {
  const auto l = index(block_.rows.size());
  base::Matrix s(l, columns.cols());
  for (Eigen::Index j = 0; j < l; ++j) {
    // A row is exchanged once only while the block is sound, so the order of taking does not
    // matter.
    s.row(j) = columns.row(block_.rows[at(j)]);
    columns.row(block_.rows[at(j)]).setZero();
  }
  block_.core.topLeftCorner(l, l).triangularView<Eigen::Lower>().solveInPlace(s);
  base::Matrix change(columns.rows(), columns.cols());
  const auto length = static_cast<int>(columns.rows());
  const auto count = static_cast<int>(l);
  blas::gemm({.m = length, .n = static_cast<int>(columns.cols()), .k = count},
             {block_.columns.data(), length}, {s.data(), count}, {change.data(), length});
  columns -= change;
  for (Eigen::Index j = 0; j < l; ++j) {
    columns.row(block_.rows[at(j)]) -= s.row(j);
  }
}

// (solve.30) for one column or state, P the exchanged rows: in the place of x_P comes what
// z_P has to be, -inverse x_P, and the rest follows along the columns of the pivot.
void PivotSequence::apply_pivot(std::size_t k, base::Vector& x) const {
  const PrincipalPivot& pivot = list_[k];
  if (pivot.rows.size() == 1) {
    const double z = x(pivot.rows[0]) * pivot.inverse(0, 0);
    if (z != 0.0) {
      x.noalias() -= z * pivot.columns.col(0);
    }
    x(pivot.rows[0]) = -z;
    return;
  }
  const Eigen::Vector2d z = pivot.inverse * Eigen::Vector2d(x(pivot.rows[0]), x(pivot.rows[1]));
  x.noalias() -= pivot.columns * z;
  x(pivot.rows[0]) = -z(0);
  x(pivot.rows[1]) = -z(1);
}

// The column of a row that this pivot exchanges, right after it: columns times inverse, the inverse
// itself in the exchanged rows.
base::Vector PivotSequence::exchanged_row_column(std::size_t k, int row) const {
  const PrincipalPivot& pivot = list_[k];
  const Eigen::Index own = pivot.rows[0] == row ? 0 : 1;
  base::Vector x = pivot.columns * pivot.inverse.col(own);
  for (std::size_t r = 0; r < pivot.rows.size(); ++r) {
    x(pivot.rows[r]) = pivot.inverse(index(r), own);
  }
  return x;
}

std::optional<std::size_t> PivotSequence::find_last_pivot_of_row(int row) const {
  const auto last = std::find_if(list_.rbegin(), list_.rend(), [&](const PrincipalPivot& pivot) {
    return std::ranges::find(pivot.rows, row) != pivot.rows.end();
  });
  return last == list_.rend() ? std::nullopt
                              : std::optional(static_cast<std::size_t>(list_.rend() - last - 1));
}

} // namespace spricka::solve
