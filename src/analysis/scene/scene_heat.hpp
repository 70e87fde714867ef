// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "fe/heat.hpp"

#include <memory>
#include <vector>

namespace spricka::analysis {

/// Temperatures of one case on the mesh of a scene.
std::shared_ptr<const fe::CaseTemperature> make_case_heat(const model::Model& model,
                                                          const Discretisation& scene,
                                                          const model::LoadCase& load_case);

/// The case but for its temperatures.
model::LoadCase without_heat(const model::LoadCase& load_case);

/// All nodal forces of temperatures [dim * node].
base::Vector heat_forces(const model::Model& model, const model::Mesh& mesh,
                         const fe::CaseTemperature& heat);

/// The cases that heat, with the factors they have.
std::vector<fe::ScaledTemperature> acting_heat(const Discretisation& scene,
                                               const base::Vector& case_factor);

} // namespace spricka::analysis
