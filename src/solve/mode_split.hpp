// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

namespace spricka::solve {

/// The rigid modes split into controllable directions, which open some row, and uncontrollable
/// ones, which open none: no contact force does work on them.
struct ModeSplit {
  /// [m, m1] basis; its columns are scaled so that the largest entry of B controllable is 1
  base::Matrix controllable;
  base::Matrix uncontrollable; ///< [m, m0] orthonormal basis, B uncontrollable = 0
};

/// A unit motion that opens less than this share of `opening_scale` moves no row: the centres of
/// round surfaces are no better known than their meshes (nodes of a refined bore lie on its edges).
inline constexpr double uncontrollable_opening = 1e-7;

/// Splits the modes by what they open, B [n, m] per unit. A unit motion is uncontrollable if it
/// opens no row by more than uncontrollable_opening of `opening_scale` (0: of the largest entry of
/// B). Columns of B have comparable lengths (rigid modes of unit norm).
ModeSplit split_controllable_modes(const base::Matrix& B, double opening_scale);

/// Loads on modes below this share of the load scale are round-off.
inline constexpr double rest_load = 1e-9;

/// An uncontrollable motion rests under loads up to this share of the load scale: the moment of a
/// load about a round shaft's axis is that of its meshed shape.
inline constexpr double resting_load = 1e-5;

/// The uncontrollable motion [m] that the loads h [m] on the modes drive, normalised; empty if
/// these loads are below `least`.
base::Vector uncontrollable_motion(const ModeSplit& split, const base::Vector& h, double least);

} // namespace spricka::solve
