// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/vec.hpp"

#include <vector>

namespace spricka::estimate {

/// Elements that go together.
inline constexpr Eigen::Index operator_lanes = 32;

/// What the points of a rule need of the elements of a block.
struct BlockGeometry {
  std::vector<double> volume;  ///< [point][lane] weight times determinant
  std::vector<double> inverse; ///< [point][reference coordinate][coordinate][lane] of Jacobians
};

/// Some elements of one type: entries of all of them next to each other, zero where a block has
/// fewer than lanes.
struct ElementBlock {
  std::vector<base::ElementId> elements;
  std::vector<double> lambda, mu; ///< [lane] Lame's constants
  BlockGeometry full;
  BlockGeometry reduced; ///< at fewer points; empty: they have no rule with fewer
};

/// Of gradients dU/dr in reference coordinates at all points of a rule the forces
/// weight det D(dU/dr J^-1) J^-T, in place [component][lane] by [point][coordinate]. Processors
/// with AVX2 take four numbers at once and come to the same bits.
void gradients_to_forces(const ElementBlock& block, const BlockGeometry& geometry, base::Matrix& G);

} // namespace spricka::estimate
