// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace spricka::solve {

/// Principal pivots of a matrix T one after the other, in product form: T itself is not formed, a
/// column of it as it was before the first pivot is led through all of them (manual, solve.30;
/// Murty 1988, chapter 2).
class PivotSequence {
public:
  /// Forgets all pivots; columns have `size` entries from now on.
  void clear(Eigen::Index size);
  /// How many pivots there are.
  [[nodiscard]] std::size_t size() const { return list_.size(); }
  [[nodiscard]] bool empty() const { return list_.empty(); }

  /// Exchanges one or two rows, whose columns [size, rows] are those of T before this pivot.
  void append(std::vector<int> rows, base::Matrix columns);
  /// Leads a column or state x [size] through pivot number `k`, counted from 0.
  void apply_pivot(std::size_t k, base::Vector& x) const;
  /// The last pivot that exchanges this row, or none.
  [[nodiscard]] std::optional<std::size_t> find_last_pivot_of_row(int row) const;
  /// The column [size] of a row that pivot `k` exchanges, right after it.
  [[nodiscard]] base::Vector exchanged_row_column(std::size_t k, int row) const;

  /// Whether apply_all_pivots() can be used: every pivot is of one row and no row has two.
  [[nodiscard]] bool can_apply_all_at_once() const { return block_.sound; }
  /// Leads many columns [size, count] through all pivots at once.
  void apply_all_pivots(base::Matrix& columns) const;

private:
  struct PrincipalPivot {
    std::vector<int> rows; ///< one or two
    base::Matrix columns;  ///< [size, rows] before the exchange
    base::Matrix inverse;  ///< of their common part
  };
  /// The pivots as one step for many columns: with x_P the entries of a column in the exchanged
  /// rows, core s = x_P (lower triangular), x <- x - columns s, x_P <- -s + what later pivots do to
  /// it.
  struct CombinedPivots {
    bool sound = true; ///< every pivot is of one row and no row has two
    std::vector<int> rows;
    base::Matrix columns; ///< [size, n] entries that a later exchange of their row overwrites are 0
    base::Matrix core;    ///< [n, n]
  };
  void add_to_block(const PrincipalPivot& pivot);

  std::vector<PrincipalPivot> list_;
  CombinedPivots block_;
};

} // namespace spricka::solve
