// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/configurational_forces.hpp"
#include "crack/tip_fields.hpp"

namespace spricka::crack {

/// Adds what the elements of a tip's domains give: energy-momentum where q varies (manual, crack.4
/// and crack.10), forces per volume (crack.19) and the temperature's gradient (crack.22) wherever q
/// is not zero.
void add_tip_element_terms(const TipAuxiliaryFields& fields, const base::Vector& u,
                           InteractionConfigurationalForces<2>& out);

} // namespace spricka::crack
