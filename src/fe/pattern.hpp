// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/sparse.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace spricka::fe {

/// A row of the system that a block of coefficients touches, and its place in the block.
struct SystemRowOfBlock {
  std::int32_t row = 0;
  std::int32_t local = 0;
};

/// Rows of many blocks (elements, superelements), each list in ascending order.
struct RowsByBlock {
  std::vector<std::int64_t> start{0}; ///< [block + 1]
  std::vector<SystemRowOfBlock> rows;

  [[nodiscard]] std::size_t size() const { return start.size() - 1; }
  /// Rows of one block, ascending by row of the system.
  [[nodiscard]] std::span<const SystemRowOfBlock> rows_of_block(std::size_t block) const {
    return {rows.data() + start[block], static_cast<std::size_t>(start[block + 1] - start[block])};
  }
  /// Adds a block; entry k of `system_rows` is the row of its k-th freedom, or negative for none.
  void add(std::span<const std::int32_t> system_rows);
};

/// Lower triangle of the n x n matrix in which every block is full; values zero, diagonals stored.
/// Linear in the work of looking at each block row once; no sorting.
base::SymmetricCsc make_matrix_pattern(std::int64_t n, const RowsByBlock& blocks);

/// Adds a symmetric block [column-major, leading dimension `stride`] at its slots of the pattern.
void add_block(base::SymmetricCsc& matrix, std::span<const SystemRowOfBlock> rows,
               const double* block, std::int64_t stride);

} // namespace spricka::fe
