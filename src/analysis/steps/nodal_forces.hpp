// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_state.hpp"

namespace spricka::analysis {

/// Nodal forces of a step whose displacements, contact and resting forces are
/// known (case factors [case] are those of its end): loads, contacts, internal forces with the
/// energies of elements, reactions and ties [dim * node], and what of the forces is out of balance.
void add_nodal_forces(const model::Model& model, const Discretisation& scene,
                      const base::Vector& case_factor, StepState& state);

} // namespace spricka::analysis
