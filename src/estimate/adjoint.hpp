// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <string>
#include <vector>

/// The adjoint of K and what follows from it.
namespace spricka::estimate {

/// K1 and K2 (columns) of one tip at the end of one step as functions of loads and gaps while the
/// contact stays as it is: what is closed stays closed, what is open stays open (manual,
/// sensitivity.1 to 5).
struct IntensityAdjoint {
  std::string why_not; ///< why there is none; empty: there is one
  base::Matrix rows;   ///< [dim * node, 2] K = rows^T u + by_force^T lambda, crack::intensity_rows
  base::Matrix by_force; ///< [contact row, 2] what forces between crack faces add to K themselves
  base::Matrix z;        ///< [dim * node, 2] displacements under the load `rows`, closed rows held
                  ///< at the gap -by_force, open ones free; zero on supports, tied where u is
  base::Matrix w;           ///< [contact row, 2] their contact forces, dK/dgap; zero on open rows
  std::vector<bool> closed; ///< [contact row] what was held; rows that are not in force: false

  [[nodiscard]] bool is_available() const { return why_not.empty(); }
};

} // namespace spricka::estimate
