// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/mesh.hpp"

namespace spricka::fe {

/// Corners of the outline of an element of the plane, anticlockwise; curved sides in 16 pieces, so
/// that slivers beside them fall with the square of that.
std::vector<base::Vec2> element_outline(const model::Mesh& mesh, base::ElementId e);

} // namespace spricka::fe
