// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "solve/contact_problem.hpp"
#include "solve/mode_split.hpp"

#include <vector>

namespace spricka::solve {

/// The contact problem on its controllable modes, scaled so that the largest entry of each column
/// of B is 1.
struct ControllableProblem {
  const base::Matrix& W; ///< [n, n]
  base::Matrix B;        ///< [n, m], full column rank
  base::Vector b;        ///< [n]
  base::Vector h;        ///< [m]
  std::vector<bool> equality;
  double tau = 0.0; ///< weight of B B^T that makes it as large as W
  base::Vector d;   ///< [n] sqrt(W_ii + tau |B_i|^2): g / d and lambda d have the same unit

  [[nodiscard]] int rows() const { return static_cast<int>(b.size()); }
  [[nodiscard]] int mode_count() const { return static_cast<int>(h.size()); }
};

/// The force [force] that loads on modes are judged by: the largest of load_scale, of the loads h
/// and of the force that closes a gap of the size of b.
double load_scale(const ContactProblem& problem);

/// The problem on the controllable modes of `split`; `problem` must outlive it.
ControllableProblem restrict_to_controllable_modes(const ContactProblem& problem,
                                                   const ModeSplit& split);

/// A row whose pivot is below this share of its diagonal entry is a combination of the rows before
/// it.
inline constexpr double redundancy = 1e-11;

} // namespace spricka::solve
