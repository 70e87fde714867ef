// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/supernodes.hpp"

#include <algorithm>

namespace spricka::solve {

namespace {

/// Number of supernodes that hold a column of a local.
std::int64_t local_fronts(const SupernodalFactor& L) {
  const std::int64_t* end = L.column + L.count;
  return std::lower_bound(L.column, end, L.locals) - L.column;
}

} // namespace

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
