// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/model.hpp"
#include "results/preview.hpp"
#include "run/condense_bodies.hpp"
#include "run/scene.hpp"
#include "run/step_solver.hpp"

#include <vector>

namespace spricka::run {

/// Which rigid modes of the bodies supports hold, which a contact can feel, which neither does.
std::vector<results::BodyPreview> held_modes(const model::Model& model, const Scene& scene,
                                             const std::vector<BodyNet>& bodies);

/// Loads that no contact can take, step by step, as the solution would find: the first refusal of
/// each step that has one. Needs no stiffness.
std::vector<Refusal> unheld_loads(const model::Model& model, const Scene& scene,
                                  const std::vector<BodyNet>& bodies);

} // namespace spricka::run
