// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/supernodes.hpp"
#include "solve/blas.hpp"

#include <algorithm>

namespace spricka::solve {

namespace {

/// The columns of locals in supernode s: block L [rows, columns], its first column and row list.
struct SupernodeFront {
  std::int64_t first;
  int columns;
  int rows;
  blas::ConstMatrixBlock block;
  const std::int64_t* row;

  [[nodiscard]] int below() const { return rows - columns; }
  [[nodiscard]] blas::ConstMatrixBlock off_diagonal() const {
    return {block.data + columns, block.stride};
  }
};

SupernodeFront front_of(const SupernodalFactor& L, std::int64_t s) {
  const std::int64_t first = L.column[s];
  const int rows = static_cast<int>(L.row_start[s + 1] - L.row_start[s]);
  // The last front of locals may hold externals as well; their columns are left alone.
  const int columns = static_cast<int>(std::min(L.column[s + 1], L.locals) - first);
  return {first, columns, rows, {L.value + L.value_start[s], rows}, L.row + L.row_start[s]};
}

/// Number of supernodes that hold a column of a local.
std::int64_t local_fronts(const SupernodalFactor& L) {
  const std::int64_t* end = L.column + L.count;
  return std::lower_bound(L.column, end, L.locals) - L.column;
}

} // namespace

void forward_substitute_locals(const SupernodalFactor& L, base::Matrix& X) {
  const int k = static_cast<int>(X.cols());
  const int stride = static_cast<int>(X.rows());
  base::Matrix update;
  const std::int64_t fronts = local_fronts(L);
  for (std::int64_t s = 0; s < fronts; ++s) {
    const SupernodeFront front = front_of(L, s);
    const blas::MatrixBlock x{X.data() + front.first, stride};
    if (X.middleRows(front.first, front.columns).isZero(0.0)) {
      continue; // loads are sparse
    }
    blas::solve_lower(front.columns, k, blas::Transposition::plain, front.block, x);
    if (front.below() == 0) {
      continue;
    }
    update.resize(front.below(), k);
    blas::gemm({.m = front.below(), .n = k, .k = front.columns}, front.off_diagonal(), x,
               {update.data(), front.below()});
    for (int j = 0; j < k; ++j) {
      for (int i = 0; i < front.below(); ++i) {
        X(front.row[front.columns + i], j) -= update(i, j);
      }
    }
  }
}

void substitute_locals(const SupernodalFactor& L, base::Matrix& X) {
  const int k = static_cast<int>(X.cols());
  const int stride = static_cast<int>(X.rows());
  base::Matrix known;
  for (std::int64_t s = local_fronts(L) - 1; s >= 0; --s) {
    const SupernodeFront front = front_of(L, s);
    const blas::MatrixBlock x{X.data() + front.first, stride};
    if (front.below() > 0) {
      known.resize(front.below(), k);
      for (int j = 0; j < k; ++j) {
        for (int i = 0; i < front.below(); ++i) {
          known(i, j) = X(front.row[front.columns + i], j);
        }
      }
      blas::gemm({.m = front.columns,
                  .n = k,
                  .k = front.below(),
                  .a = blas::Transposition::transposed,
                  .alpha = -1.0,
                  .beta = 1.0},
                 front.off_diagonal(), {known.data(), front.below()}, x);
    }
    blas::solve_lower(front.columns, k, blas::Transposition::transposed, front.block, x);
  }
}

base::Matrix trailing_block(const SupernodalFactor& L) {
  const std::int64_t externals = L.n - L.locals;
  base::Matrix R = base::Matrix::Zero(externals, externals);
  // Externals begin within the last front of locals, or behind it.
  for (std::int64_t s = std::max<std::int64_t>(0, local_fronts(L) - 1); s < L.count; ++s) {
    const std::int64_t rows = L.row_start[s + 1] - L.row_start[s];
    const std::int64_t first = std::max(L.column[s], L.locals);
    for (std::int64_t j = first; j < L.column[s + 1]; ++j) {
      const std::int64_t c = j - L.column[s];
      const double* column = L.value + L.value_start[s] + c * rows;
      for (std::int64_t i = c; i < rows;
           ++i) { // the diagonal block holds rubbish above its diagonal
        R(L.row[L.row_start[s] + i] - L.locals, j - L.locals) = column[i];
      }
    }
  }
  return R;
}

} // namespace spricka::solve
