// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/tip_setting.hpp"

/// What loads at the tip itself have a part in T.
namespace spricka::crack {

/// Normal stress that acts on the crack faces at the tip itself, their mean [stress]: pressure
/// gives its negative.
double stress_on_crack_faces_at_tip(const TipContext& set, const mesh::CrackFront& front);

/// E' times the free thermal strain along the crack at the tip [stress]: strains there are those of
/// T and this (manual, crack.26). Mean over the elements round the tip.
double thermal_stress_at_tip(const TipContext& set, const mesh::CrackFront& front);

} // namespace spricka::crack
