// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/script_size_request.hpp"

namespace spricka::mesher {

/// Asks gmsh for sizes beyond those of the script that is open and not yet meshed, and meshes its
/// curves. Curves that are too coarse somewhere get the wanted spacing, also those with a fixed
/// number of elements (Transfinite Curve); where the spacing they had is fine enough, they keep it.
void apply_sizes_and_mesh_curves(const mesh::ScriptSizeMap& size);

} // namespace spricka::mesher
