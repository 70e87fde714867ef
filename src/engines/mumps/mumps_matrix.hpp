// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/sparse.hpp"
#include "base/vec.hpp"

#include <cstdint>
#include <vector>

namespace spricka::engines {

/// K as MUMPS reads it: triplets of the lower triangle, counted from 1. Locals are scaled so that
/// their diagonal lies between 1/2 and 2: then a pivot is what elimination has left of its diagonal
/// entry. Scales are powers of two, so that scaling rounds nothing off; externals have none, as
/// their Schur complement is wanted as it is.
class MumpsMatrix {
public:
  /// K is moved from.
  MumpsMatrix(base::SymmetricCsc& K, std::int64_t locals);

  [[nodiscard]] std::int64_t size() const { return static_cast<std::int64_t>(scale_.size()); }
  [[nodiscard]] std::int64_t locals() const { return locals_; }
  [[nodiscard]] std::int64_t entries() const { return static_cast<std::int64_t>(row_.size()); }
  [[nodiscard]] std::vector<int>& rows() { return row_; }
  [[nodiscard]] std::vector<int>& columns() { return column_; }
  [[nodiscard]] std::vector<double>& values() { return value_; }
  /// Residuals need no columns, and MUMPS only until it has the factor.
  void drop_columns() { column_ = std::vector<int>(); }
  [[nodiscard]] double scale(std::int64_t row) const {
    return scale_[static_cast<std::size_t>(row)];
  }
  /// Loads as those of the scaled matrix, and its displacements as those of K: both the same.
  void apply_scale(base::Matrix& X) const;
  /// What is missing for balance at the locals, f - K u [n, k] with zeros for the externals, and by
  /// how much of |K| |u| + |f| at the worst row (Oettli and Prager 1964). All of it scaled.
  struct Residual {
    base::Matrix value;
    double backward_error = 0.0;
  };
  [[nodiscard]] Residual residual_of(const base::Matrix& u, const base::Matrix& f) const;
  /// K again, as it was given; this is empty afterwards.
  [[nodiscard]] base::SymmetricCsc give_back();

private:
  std::int64_t locals_;
  std::vector<std::int64_t> start_; ///< [n + 1] of the columns
  std::vector<int> row_, column_;
  std::vector<double> value_;
  std::vector<double> scale_; ///< [n]
};

} // namespace spricka::engines
