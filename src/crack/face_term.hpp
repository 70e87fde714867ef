// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/tip_setting.hpp"

namespace spricka::crack {

/// Adds what tractions on the lips give (manual, crack.20): minus the integral of q t . u,1 along
/// them. Straight lips.
void add_face_terms(const TipSetting& set, const base::Vector& u, NodalForces& out);

/// Normal stress that acts on the lips at the tip itself, their mean [stress]: pressure gives its
/// negative.
double stress_on_lips_at_tip(const TipSetting& set, const mesh::Front& front);

} // namespace spricka::crack
