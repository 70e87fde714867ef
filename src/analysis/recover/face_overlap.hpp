// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_state.hpp"

#include <string>

namespace spricka::analysis {

/// Whether the faces of a crack in space lie in one another, in words, or empty: then K is that of
/// a crack whose faces pass through each other.
std::string describe_face_overlap(const Discretisation& scene, const mesh::CrackFront& front,
                                  const StepState& state);

} // namespace spricka::analysis
