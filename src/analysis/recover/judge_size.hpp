// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/bodies/condense_bodies.hpp"
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_state.hpp"
#include "results/results.hpp"

#include <vector>

namespace spricka::analysis {

/// Warns in `out` of bodies that are strained by more than 1 % on the whole, or bent or turned by
/// more than 10 % of their size: beyond that the linear theory fails, and a modulus, load or fit is
/// mostly in another unit than meant. Of solids only the second is looked at.
void warn_of_large_deformation(const model::Model& model, const Discretisation& scene,
                               const std::vector<SubstructuredBody>& bodies, const StepState& state,
                               results::LoadStepResult& out);

/// Bodies that were small in strain and turn at the first length and are not at a later one have
/// lost their ligament: their notes say so instead of asking for units.
void reword_notes_of_broken_ligaments(results::RunResult& run);

} // namespace spricka::analysis
