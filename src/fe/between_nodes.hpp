// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/forward.hpp"

namespace spricka::fe {

/// Where a displacement given as an expression leaves what the nodes make of it.
struct DisplacementInterpolationError {
  double off = 0.0; ///< largest distance of a component from the interpolation of its nodal values
  base::Vec3 place = base::Vec3::Zero();
};

/// Over the sides of elements all of whose nodes the load is given at, by 32 points along an edge
/// and 64 on a face.
DisplacementInterpolationError displacement_interpolation_error(const model::Mesh& mesh,
                                                                const model::Load& load);

} // namespace spricka::fe
