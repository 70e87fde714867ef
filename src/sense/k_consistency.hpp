// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/results.hpp"

#include <string>
#include <vector>

/// K found in two ways that should agree: by the near-tip fields, by the energy release rate, of a
/// tip by domains of different size and by the opening of the faces, too.
namespace spricka::sense {

/// The ways that part at one tip of a step; empty: they agree, there is but one, or K is round-off.
std::string describe_k_mismatch(const results::LoadStepResult& step,
                                const results::FrontResult& tip);

/// One line for each front along which two ways to K part by more than K's error bar, and by more
/// than on sound meshes: the worst place of its steps and lengths. Fronts that nothing loads do not
/// count, nor do, in space, ends on the body's surface, where both ways depend on the mesh, and
/// places where the faces touch.
std::vector<std::string> k_consistency_warnings(const results::RunResult& run);

} // namespace spricka::sense
