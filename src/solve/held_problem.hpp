// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "solve/contact_problem.hpp"
#include "solve/mode_split.hpp"

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

/// Which loads on modes count: the loads themselves, and the force that a gap of the size of b
/// needs.
double load_scale(const ContactProblem& problem);

/// The problem on the modes that some row feels; `problem` must outlive it.
HeldProblem held_problem(const ContactProblem& problem, const ModeSplit& split);

/// Rows whose pivot, over the diagonal, is below this are combinations of the rows before them.
inline constexpr double redundancy = 1e-11;

} // namespace spricka::solve
