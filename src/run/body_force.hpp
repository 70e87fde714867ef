// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/stress_intensity.hpp"
#include "run/scene.hpp"

#include <vector>

namespace spricka::run {

/// Body force density at a step's end in the elements of some domains; empty when nothing loads
/// them. `scene` and `model` must outlive the function returned.
crack::BodyForce body_force(const model::Model& model, const Scene& scene,
                            const std::vector<crack::ExtensionField>& fields,
                            const base::Vector& case_factor);

/// Whether a body force near a tip varies in space: the part of G that comes from its gradient is
/// left out.
bool body_force_varies(const model::Model& model, const Scene& scene,
                       const std::vector<crack::ExtensionField>& fields,
                       const base::Vector& case_factor);

} // namespace spricka::run
