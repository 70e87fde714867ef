// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>

namespace spricka::results {

/// A stress as results keep it: xx yy zz xy yz zx.
using Stress = std::array<double, 6>;

/// Equivalent stress by the energy of distortion, never negative [stress].
double von_mises(const Stress& s);

/// Principal stresses, the largest first.
std::array<double, 3> principal_stresses(const Stress& s);

} // namespace spricka::results
