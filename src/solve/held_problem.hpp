// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <vector>

namespace spricka::solve {

/// The contact problem without the modes that no row touches; modes scaled so that the largest
/// entry of each column of B is 1.
struct HeldProblem {
  const base::Matrix& W; ///< [n, n]
  base::Matrix B;        ///< [n, m], full column rank
  base::Vector b;        ///< [n]
  base::Vector h;        ///< [m]
  std::vector<bool> equality;
  double tau = 0.0; ///< weight of B B^T that makes it as large as W
  base::Vector d;   ///< [n] sqrt(W_ii + tau |B_i|^2): g / d and lambda d have the same unit

  [[nodiscard]] int rows() const { return static_cast<int>(b.size()); }
  [[nodiscard]] int modes() const { return static_cast<int>(h.size()); }
};

struct ContactProblem;

/// The problem on the modes alpha = felt a. `problem` must outlive the answer.
HeldProblem held_problem(const ContactProblem& problem, const base::Matrix& felt);

/// Rows whose pivot, over the diagonal, is below this are combinations of the rows before them.
inline constexpr double redundancy = 1e-11;

} // namespace spricka::solve
