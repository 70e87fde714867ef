// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <string>

namespace spricka::results {

/// One solution on the way to K within a tolerance ($TIPNET TOL).
struct ToleranceRound {
  int number = 0;
  std::size_t unknowns = 0; ///< freedoms of the finest of its meshes
  std::string worst;        ///< "K1 of C1.1, step LOAD, a = 10.8"
  double bar = 0.0;         ///< there, over hypot(K1, K2)
  double wanted = 0.0;      ///< TOL
  double cpu = 0.0;         ///< [s] reading, meshing and solving
  std::string next;         ///< what is made finer, or why it ends
};

} // namespace spricka::results
