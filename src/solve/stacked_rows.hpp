// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/index.hpp"
#include "base/sparse.hpp"
#include "solve/dense_block.hpp"
#include "solve/factor_report.hpp"
#include "solve/layered_cholesky.hpp"
#include "solve/unknown_places.hpp"

#include <cstdint>
#include <span>
#include <vector>

/// Which rows of a matrix with dense blocks stand on which floor (solve/stacked.hpp).
namespace spricka::solve {

struct TwoLevelRows {
  std::vector<std::int64_t> below;   ///< rows of K that are eliminated below
  std::vector<std::int64_t> top;     ///< rows of K on top, externals last
  std::vector<Eigen::Index> touched; ///< places in `top` that the sparse matrix touches
  Eigen::Index external = 0;
  std::vector<Eigen::Index> early; ///< places in `top` of externals that only the block has

  [[nodiscard]] Eigen::Index inner_count() const { return base::index(top.size()) - external; }
};

/// `early` stays empty.
TwoLevelRows divide_rows_by_level(const base::SymmetricCsc& K, std::int64_t externals,
                                  std::span<const CondensedNetBlock> blocks);

/// Externals that only the one block has, if they are worth it.
void find_externals_of_block_alone(const base::SymmetricCsc& K,
                                   std::span<const CondensedNetBlock> blocks, TwoLevelRows& rows);

/// Early and late rows of a block, as FirstBlockFactor has them.
EarlyLateRowPartition partition_block(const TwoLevelRows& rows, const CondensedNetBlock& block);

/// The places on top, -1: none, of a block's rows.
std::vector<Eigen::Index> upper_level_positions(const CondensedNetBlock& block,
                                                const std::vector<std::int64_t>& top);

/// The sparse matrix of the rows below, then the touched ones.
base::SymmetricCsc lower_level_matrix(const base::SymmetricCsc& K, const TwoLevelRows& rows);

/// Where its unknowns are, of those of K.
UnknownPlaces lower_level_places(const UnknownPlaces& places, const TwoLevelRows& rows);

/// What the top costs; `kept`: its early rows have been eliminated before.
void add_upper_level_cost(const TwoLevelRows& rows, bool kept, FactorReport& report);

} // namespace spricka::solve
