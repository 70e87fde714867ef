// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <vector>

namespace spricka::solve {

/// The linear complementarity problem w = q + M z, w >= 0, z >= 0, w z = 0.
struct LemkeResult {
  bool solved = false;     ///< false: a ray, or the limit of pivots
  std::vector<bool> basic; ///< [n] z_i is basic, so that w_i = 0
  int pivots = 0;
};

/// Lemke's complementary pivoting (Lemke 1965) with a covering vector `cover` > 0; ties are broken
/// lexicographically, so that it ends (Cottle, Pang and Stone 1992, section 4.9).
LemkeResult solve_by_lemke_pivoting(const base::Matrix& M, const base::Vector& q,
                                    const base::Vector& cover, int max_pivots);

} // namespace spricka::solve
