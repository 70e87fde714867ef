// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace spricka::solve {

/// A condensed net as one full block on rows of another matrix.
struct CondensedNetBlock {
  std::vector<std::int64_t> rows;          ///< [m] rows there, -1: none
  const base::Matrix* stiffness = nullptr; ///< [m, m] symmetric; not looked at by forecasts
};

/// Whether such blocks are better kept out of the sparse matrix: together with the externals they
/// fill most of what they touch.
bool is_two_level_cheaper(std::span<const CondensedNetBlock> blocks, std::int64_t rows,
                          std::int64_t externals);

} // namespace spricka::solve
