// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_state.hpp"
#include "crack/stress_intensity.hpp"
#include "results/results.hpp"

namespace spricka::analysis {

/// A tip at the end of a step, and K as its rings find it.
struct TipState {
  const model::Model& model;
  const Discretisation& scene;
  const mesh::CrackFront& front;
  const StepState& state;
  const crack::StressIntensity& K;
};

/// What the faces of a crack, and the materials beside it, make of the K of its tip: K1 = 0 where
/// they touch, doubt where K is no answer; notes where the mesh does not resolve what they do.
void check_crack_faces(const TipState& at, results::TipResult& result, results::StepResult& out);

} // namespace spricka::analysis
