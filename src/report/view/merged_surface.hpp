// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "report/view/shown_surface.hpp"

namespace spricka::report {

/// The surface without mid nodes but where an edge is bowed or its node is not in its middle, as
/// next to crack fronts.
ShownSurface without_straight_mid_nodes(const model::Mesh& mesh, const ShownSurface& surface);

/// The surface with the points of each of its bodies that lie in one cube made one; `cubes` of them
/// along the largest extent, at most 1024. Points of crack faces stay. Faces that become a line go.
ShownSurface merge_points(const model::Mesh& mesh, const ShownSurface& surface, std::size_t cubes);

} // namespace spricka::report
