// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

namespace spricka::solve {

/// The rigid modes split into directions that some row feels and directions that none does.
struct ModeSplit {
  base::Matrix felt; ///< [m, m1] alpha = felt a, columns scaled so that B felt has largest entry 1
  base::Matrix unfelt; ///< [m, m0] orthonormal, B unfelt = 0
};

/// A unit motion that opens less than this share of `opening_scale` moves no row: the centres of
/// round surfaces are no better known than their meshes (nodes of a refined bore lie on its edges).
inline constexpr double unfelt_opening = 1e-7;

/// Motions that open no row of B [n, m] by unfelt_opening of `opening_scale` (0: the largest of B)
/// a unit are unfelt. Columns of B have comparable lengths (rigid modes of unit norm).
ModeSplit split_modes(const base::Matrix& B, double opening_scale);

/// Loads on modes below this share of the load scale are round-off.
inline constexpr double rest_load = 1e-9;

/// A motion that no row feels rests under loads up to this share of the load scale: the moment of a
/// load about a round shaft's axis is that of its meshed shape.
inline constexpr double resting_load = 1e-5;

/// Of the loads h [m] on the modes, the motion that no row feels and h drives, normalised; empty if
/// there is none (loads below `least`).
base::Vector unfelt_motion(const ModeSplit& split, const base::Vector& h, double least);

} // namespace spricka::solve
