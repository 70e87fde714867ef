// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "analysis/steps/solid_face_contact.hpp"
#include "analysis/steps/step_state.hpp"
#include "crack/stress_intensity.hpp"
#include "results/results.hpp"

#include <vector>

namespace spricka::analysis {

/// What domains may find for K1 below 0 where faces in contact do not touch, over the largest K.
inline constexpr double worst_open_front = 0.01;

/// A front at the end of a step, and K as its domains find it [point].
struct FrontStepState {
  const model::Model& model;
  const Discretisation& scene;
  const mesh::CrackFront& front;
  const StepState& state;
  const std::vector<crack::StressIntensity>& K;
  const std::vector<FrontFaceContact>& faces; ///< [point] in space; empty: they touch nowhere
};

/// What the faces of a crack, and the materials beside it, make of the K of its front: K1 = 0 where
/// they touch, doubt where K is no answer; notes where the mesh does not resolve what they do.
void judge_K_by_faces_and_materials(const FrontStepState& at, results::FrontResult& result,
                                    results::LoadStepResult& out);

} // namespace spricka::analysis
