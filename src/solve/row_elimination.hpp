// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "solve/supernodes.hpp"

#include <cstdint>
#include <vector>

namespace spricka::solve {

/// Sparse columns F [n, k] of right-hand sides: where contact rows act on the unknowns of a body.
struct SparseRightHandSides {
  std::vector<std::int64_t> start{0}; ///< [k + 1] into row and value
  std::vector<std::int64_t> row;
  std::vector<double> value;

  [[nodiscard]] std::int64_t count() const { return static_cast<std::int64_t>(start.size()) - 1; }
  bool operator==(const SparseRightHandSides&) const = default;
};

/// What a body's locals do with such columns while its externals are held.
struct RowCompliance {
  base::Matrix W;         ///< [k, k] F_l^T K_ll^-1 F_l
  base::Matrix condensed; ///< [externals, k] F_e - K_el K_ll^-1 F_l
  double flops = 0.0;
};

/// Y = L11^-1 F_l for many sparse columns, front by front: a column is met in the fronts on the way
/// up from its entries alone, and what is left of Y of a front is Y^T Y added up. It is what a
/// factorisation with the columns as last rows would do, without keeping their part of the factor.
class RowElimination {
public:
  /// Which columns each front meets, and what that will cost. F has its rows in the order of
  /// elimination; both must outlive this.
  RowElimination(const SupernodalFactor& L, const SparseRightHandSides& F);

  [[nodiscard]] double flops() const { return flops_; }
  [[nodiscard]] double workspace() const { return workspace_; } ///< [bytes] besides W

  /// W = Y^T Y [k, k], symmetric to the last bit; condensed [n - locals, k] <- F_e - L21 Y. Once.
  /// No bit depends on the threads.
  base::Matrix compute_compliance(base::Matrix& condensed, int threads);

private:
  struct RightHandSideEntryInFront {
    int column;
    int row; ///< of its front
    double value;
  };
  void reach_up(const SparseRightHandSides& F);
  void count_cost();
  base::Matrix& block_of(std::int64_t front);
  void eliminate(std::int64_t front, base::Matrix& W, base::Matrix& condensed);
  void hand_up(std::int64_t front, const base::Matrix& X, int first, int width,
               base::Matrix& condensed);

  const SupernodalFactor& L_;
  std::int64_t fronts_;
  std::vector<std::int64_t> front_of_;                      ///< [locals]
  std::vector<std::vector<RightHandSideEntryInFront>> own_; ///< [front] entries of F
  std::vector<std::vector<int>> columns_; ///< [front] those that it meets, ascending
  std::vector<base::Matrix> block_;       ///< [front] its rows of these, while they are being made
  double flops_ = 0.0;
  double workspace_ = 0.0;
  int threads_ = 1;
};

} // namespace spricka::solve
