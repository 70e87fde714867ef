// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/results.hpp"
#include "run/condense_bodies.hpp"
#include "run/scene.hpp"

#include <vector>

namespace spricka::run {

/// Warns in `out` of bodies that are strained or turned by more than 1 % in this step: half the
/// range of their displacements over half their size. Beyond that the linear theory fails, and a
/// modulus, load or fit is mostly in another unit than meant.
void judge_size(const Scene& scene, const std::vector<BodyNet>& bodies, results::StepResult& out);

} // namespace spricka::run
