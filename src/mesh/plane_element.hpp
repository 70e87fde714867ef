// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/mesh.hpp"

namespace spricka::mesh {

/// Mean of the corners of a plane element.
base::Vec2 element_centroid(const model::Mesh& mesh, base::ElementId e);

/// Mean length of the sides of a plane element, from corner to corner [length].
double mean_side_length(const model::Mesh& mesh, base::ElementId e);

} // namespace spricka::mesh
