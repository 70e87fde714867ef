// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/bodies/condense_bodies.hpp"
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_state.hpp"
#include "model/model.hpp"
#include "results/preview.hpp"

#include <vector>

namespace spricka::analysis {

/// Which rigid modes of the bodies supports hold, which a contact can feel, which neither does.
std::vector<results::BodyPreview> held_modes(const model::Model& model, const Scene& scene,
                                             const std::vector<BodyNet>& bodies);

/// Loads that no contact can take, step by step, as the solution would find: the first refusal of
/// each step that has one. Needs no stiffness.
std::vector<Refusal> unheld_loads(const model::Model& model, const Scene& scene,
                                  const std::vector<BodyNet>& bodies);

} // namespace spricka::analysis
