// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <vector>

namespace spricka::base {

/// Lower triangle of a symmetric matrix by columns, rows ascending in each column, diagonal always
/// stored. 64-bit indices, as the 64-bit CHOLMOD interface wants them.
struct SymmetricCsc {
  std::int64_t n = 0;
  std::vector<std::int64_t> start; ///< [n + 1]
  std::vector<std::int64_t> row;   ///< [nnz]
  std::vector<double> value;       ///< [nnz]
};

} // namespace spricka::base
