// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/law.hpp"

#include <array>
#include <vector>

/// How stresses grow towards a corner: the exponents of u ~ r^lambda in a wedge of one or more
/// materials.
namespace spricka::estimate {

/// A part of a wedge between two angles, of one material.
struct WedgeSector {
  double from = 0.0; ///< [rad], below `to`
  double to = 0.0;
  fe::ConstitutiveLaw law;
};

/// Materials about a point, the angles ascending, each sector beginning where the one before ends.
struct MultiMaterialWedge {
  std::vector<WedgeSector> sectors;
  bool whole = false;                        ///< the last sector ends where the first begins
  std::array<std::array<bool, 2>, 2> held{}; ///< [first, last side][x, y], not of whole ones
};

/// The least real part of the exponents between 0 and 1 that the wedge has, 1 if there is none:
/// stresses grow like r^(lambda - 1). By finite elements of degree 4 in the angle (Leguillon and
/// Sanchez-Palencia 1987; manual, estimate.15).
double singularity_exponent(const MultiMaterialWedge& wedge);

} // namespace spricka::estimate
