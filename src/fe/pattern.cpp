// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/pattern.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace spricka::fe {

void RowsByBlock::add(std::span<const std::int32_t> system_rows) {
  for (std::size_t k = 0; k < system_rows.size(); ++k) {
    if (system_rows[k] >= 0) {
      rows.push_back({system_rows[k], static_cast<std::int32_t>(k)});
    }
  }
  std::sort(rows.begin() + start.back(), rows.end(),
            [](const SystemRowOfBlock& a, const SystemRowOfBlock& b) {
              return a.row != b.row ? a.row < b.row : a.local < b.local;
            });
  start.push_back(static_cast<std::int64_t>(rows.size()));
}

namespace {

// Which blocks touch a row: lists by row, ascending.
struct Incidence {
  std::vector<std::int64_t> start;
  std::vector<std::int32_t> block;
};

Incidence blocks_of_rows(std::size_t n, const RowsByBlock& blocks) {
  Incidence lists;
  lists.start.assign(n + 1, 0);
  for (const SystemRowOfBlock& r : blocks.rows) {
    ++lists.start[static_cast<std::size_t>(r.row) + 1];
  }
  std::partial_sum(lists.start.begin(), lists.start.end(), lists.start.begin());
  lists.block.resize(blocks.rows.size());
  std::vector<std::int64_t> next(lists.start.begin(), lists.start.end() - 1);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (const SystemRowOfBlock& r : blocks.rows_of_block(b)) {
      const std::int64_t slot = next[static_cast<std::size_t>(r.row)]++;
      lists.block[static_cast<std::size_t>(slot)] = static_cast<std::int32_t>(b);
    }
  }
  return lists;
}

} // namespace

base::SymmetricCsc make_matrix_pattern(std::int64_t n, const RowsByBlock& blocks) {
  const auto count = static_cast<std::size_t>(n);
  const Incidence lists = blocks_of_rows(count, blocks);
  base::SymmetricCsc matrix;
  matrix.n = n;
  matrix.start.assign(count + 1, 0);

  // Columns j <= i of each row i, each once, in no order.
  std::vector<std::int64_t> row_start(count + 1, 0);
  std::vector<std::int32_t> column;
  std::vector<std::int32_t> seen(count, -1);
  for (std::size_t i = 0; i < count; ++i) {
    const auto row = static_cast<std::int32_t>(i);
    seen[i] = row;
    column.push_back(row);
    for (std::int64_t k = lists.start[i]; k < lists.start[i + 1]; ++k) {
      const auto b = static_cast<std::size_t>(lists.block[static_cast<std::size_t>(k)]);
      for (const SystemRowOfBlock& r : blocks.rows_of_block(b)) {
        if (r.row >= row) {
          break;
        }
        if (seen[static_cast<std::size_t>(r.row)] != row) {
          seen[static_cast<std::size_t>(r.row)] = row;
          column.push_back(r.row);
        }
      }
    }
    row_start[i + 1] = static_cast<std::int64_t>(column.size());
  }

  // Turned over: rows arrive in ascending order in every column.
  for (const std::int32_t j : column) {
    ++matrix.start[static_cast<std::size_t>(j) + 1];
  }
  std::partial_sum(matrix.start.begin(), matrix.start.end(), matrix.start.begin());
  matrix.row.resize(column.size());
  matrix.value.assign(column.size(), 0.0);
  std::vector<std::int64_t> next(matrix.start.begin(), matrix.start.end() - 1);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::int64_t k = row_start[i]; k < row_start[i + 1]; ++k) {
      const auto j = static_cast<std::size_t>(column[static_cast<std::size_t>(k)]);
      matrix.row[static_cast<std::size_t>(next[j]++)] = static_cast<std::int64_t>(i);
    }
  }
  return matrix;
}

void add_block(base::SymmetricCsc& matrix, std::span<const SystemRowOfBlock> rows,
               const double* block, std::int64_t stride) {
  for (std::size_t a = 0; a < rows.size(); ++a) {
    const auto j = static_cast<std::size_t>(rows[a].row);
    const double* const column = block + stride * rows[a].local;
    auto slot = matrix.row.cbegin() + matrix.start[j];
    const auto end = matrix.row.cbegin() + matrix.start[j + 1];
    for (std::size_t b = a; b < rows.size(); ++b) {
      // The next slot is the wanted one within a dense block and often elsewhere.
      if (*slot != rows[b].row) {
        slot = std::lower_bound(slot, end, std::int64_t{rows[b].row});
      }
      assert(slot != end && *slot == rows[b].row);
      // Two freedoms of a block on one row (a collapsed side) meet on the diagonal twice.
      const double factor = b != a && rows[b].row == rows[a].row ? 2.0 : 1.0;
      matrix.value[static_cast<std::size_t>(slot - matrix.row.cbegin())] +=
          factor * column[rows[b].local];
      if (b + 1 < rows.size() && rows[b + 1].row != rows[b].row) {
        ++slot;
      }
    }
  }
}

} // namespace spricka::fe
