// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/tip_setting.hpp"

namespace spricka::crack {

/// E' times the free thermal strain along the crack at the tip [stress]: strains there are those of
/// T and this (manual, crack.26). Mean over the elements round the tip.
double thermal_stress_at_tip(const TipSetting& set, const mesh::CrackFront& front);

} // namespace spricka::crack
