// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/tip_setting.hpp"

namespace spricka::crack {

/// Adds what tractions on the crack faces give (manual, crack.20): minus the integral of q t . u,1
/// along them. Straight crack faces.
void add_face_terms(const TipSetting& set, const base::Vector& u, ConfigurationalForces& out);

/// Normal stress that acts on the crack faces at the tip itself, their mean [stress]: pressure
/// gives its negative.
double stress_on_crack_faces_at_tip(const TipSetting& set, const mesh::CrackFront& front);

} // namespace spricka::crack
