// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/steps/solid_face_contact.hpp"
#include "crack/stress_intensity.hpp"
#include "results/results.hpp"

#include <vector>

namespace spricka::analysis {

/// What domains may find for K1 below 0 where faces in contact do not touch, over the largest K.
inline constexpr double worst_open_front = 0.01;

/// A front at the end of a step, and K as its domains find it [point].
struct FrontState {
  const model::Model& model;
  const Discretisation& scene;
  const mesh::CrackFront& front;
  const StepState& state;
  const std::vector<crack::StressIntensity>& K;
  const std::vector<FrontFaces>& faces; ///< [point]; empty: they touch nowhere
};

/// What the faces of a crack in space make of K along its front: K1 = 0 at points where they touch,
/// doubt where K is no answer; notes on both.
void check_front_faces(const FrontState& at, results::FrontResult& result,
                       results::StepResult& out);

} // namespace spricka::analysis
