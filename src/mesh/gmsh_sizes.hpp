// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>

namespace spricka::mesh {

/// Element size wanted at a point of the script's own coordinates; where the script asks for less,
/// its wish stands.
using SizeWish = std::function<double(double x, double y)>;

/// Asks gmsh for sizes beyond those of the script that is open and not yet meshed. Curves with a
/// fixed number of elements (Transfinite Curve) that are too coarse somewhere are freed; they keep
/// the spacing they had where that is fine enough.
void wish_for_sizes(const SizeWish& size);

} // namespace spricka::mesh
