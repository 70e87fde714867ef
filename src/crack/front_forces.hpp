// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/configurational_forces.hpp"
#include "crack/front_fields.hpp"

namespace spricka::crack {

/// What the elements of the domains give: energy-momentum, the divergence of the auxiliary fields'
/// stress, forces per volume and the temperature's gradient (crack_space.6, crack_space.8).
void add_front_element_terms(const FrontAuxiliaryFields& fields, const FrontLoads& loads,
                             const base::Vector& u, InteractionConfigurationalForces<3>& out);

} // namespace spricka::crack
