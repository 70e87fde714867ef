// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <cstdint>

namespace spricka::solve {

/// View of a supernodal Cholesky factor L (columns k1 .. k2 of a supernode share their rows and are
/// stored as one column-major block, diagonal block first). Rows and columns are in elimination
/// order, `locals` of them first, externals after. A supernode may lie across that border.
struct SupernodalFactor {
  std::int64_t n = 0;
  std::int64_t locals = 0;
  std::int64_t count = 0;
  const std::int64_t* column = nullptr;      ///< [count + 1] first column
  const std::int64_t* row_start = nullptr;   ///< [count + 1] into row
  const std::int64_t* value_start = nullptr; ///< [count + 1] into value
  const std::int64_t* row = nullptr;
  const double* value = nullptr;
};

/// The block of externals [n - locals, n - locals], zero above the diagonal.
base::Matrix trailing_block(const SupernodalFactor& L);

} // namespace spricka::solve
