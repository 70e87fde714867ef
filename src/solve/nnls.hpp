// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <vector>

namespace spricka::solve {

struct NonNegativeSolution {
  base::Vector x;            ///< [n]
  std::vector<int> positive; ///< rows of x above zero, ascending; at most as many as A has rows
};

/// min |A x - t| over x >= 0 for a flat A [m, n] (Lawson and Hanson 1974, chapter 23). Finite.
NonNegativeSolution non_negative_least_squares(const base::Matrix& A, const base::Vector& t);

} // namespace spricka::solve
