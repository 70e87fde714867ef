// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/tip_setting.hpp"

#include <array>
#include <optional>

namespace spricka::crack {

/// K1 and K2, K3 = 0, from the displacements of the crack faces against each other at the two nodes
/// behind the tip (Shih, deLorenzi, German 1976; manual, crack.27): a coarse value by a way that
/// has nothing in common with the domains. Empty where the mesh has no crack faces.
std::optional<std::array<double, 3>> tip_K_from_face_opening(const TipContext& set,
                                                             const mesh::CrackedMesh& cracked,
                                                             const mesh::CrackFront& front,
                                                             const base::Vector& u);

} // namespace spricka::crack
