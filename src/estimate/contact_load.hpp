// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "estimate/contact_edges.hpp"

#include <vector>

namespace spricka::estimate {

/// What a unit of a row's multiplier does to a mode: 2 e of the edge, its outer normal.
struct ContactModeWeight {
  std::size_t freedom = 0;
  std::size_t row = 0; ///< normal row of the pair
  double weight = 0.0; ///< [area]
};

/// The modes of target edges in the rows of a pair of hats on half edges: integral of hat times
/// mode along the normal of the rows (manual, estimate.14). Nothing for node pairs and rigid
/// targets.
std::vector<ContactModeWeight> target_mode_weights(const EdgeTable& table,
                                                   const contact::PairConstraints& pair);

} // namespace spricka::estimate
