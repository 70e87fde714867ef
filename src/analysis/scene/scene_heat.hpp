// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "fe/heat.hpp"

#include <memory>
#include <vector>

namespace spricka::analysis {

/// Temperatures of one case on the mesh of a scene.
std::shared_ptr<const fe::CaseTemperature> scene_case_temperature(const model::Model& model,
                                                                  const Discretisation& scene,
                                                                  const model::LoadCase& load_case);

/// The case but for its temperatures.
model::LoadCase without_temperature_loads(const model::LoadCase& load_case);

/// All nodal forces of temperatures [dim * node].
base::Vector thermal_nodal_forces(const model::Model& model, const model::Mesh& mesh,
                                  const fe::CaseTemperature& heat);

/// The cases that heat, with the factors they have.
std::vector<fe::ScaledTemperature> scaled_case_temperatures(const Discretisation& scene,
                                                            const base::Vector& case_factor);

} // namespace spricka::analysis
