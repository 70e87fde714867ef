// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/dense_block.hpp"
#include "base/index.hpp"

#include <algorithm>

namespace spricka::solve {

using base::at;

bool is_two_level_cheaper(std::span<const CondensedNetBlock> blocks, std::int64_t rows,
                          std::int64_t externals) {
  std::vector<bool> on_top(at(rows), false);
  std::fill(on_top.end() - externals, on_top.end(), true);
  double filled = 0.0;
  for (const CondensedNetBlock& b : blocks) {
    for (const std::int64_t row : b.rows) {
      if (row >= 0) {
        on_top[at(row)] = true;
      }
    }
    filled += static_cast<double>(b.rows.size()) * static_cast<double>(b.rows.size());
  }
  const auto size = static_cast<double>(std::ranges::count(on_top, true));
  return !blocks.empty() && 2.0 * filled > size * size;
}

} // namespace spricka::solve
