// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>

namespace spricka::mesh {

/// Element size wanted at a point of the script's own coordinates; where the script asks for less,
/// its wish stands.
using SizeWish = std::function<double(double x, double y)>;

/// Asks gmsh for sizes beyond those of the script that is open and not yet meshed, and meshes its
/// curves. Curves that are too coarse somewhere get the wanted spacing, also those with a fixed
/// number of elements (Transfinite Curve); where the spacing they had is fine enough, they keep it.
void wish_for_sizes(const SizeWish& size);

} // namespace spricka::mesh
