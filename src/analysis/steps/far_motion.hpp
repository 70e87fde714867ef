// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/bodies/condense_bodies.hpp"
#include "analysis/scene/scene.hpp"
#include "base/outcome.hpp"
#include "contact/system.hpp"

#include <vector>

namespace spricka::analysis {

/// What a step solved for on the condensed bodies, indices of `bodies`.
struct SolvedContactIncrement {
  const contact::ContactSystem& system;
  const std::vector<std::size_t>& condensed;
  const contact::ContactSystem::IncrementProblem& problem;
  const contact::ContactSystem::IncrementSolution& solution;
};

/// A body that moves as a rigid one, along surfaces that hardly resist it, by more than ten times
/// the gaps that closed, the displacements by deformation and the prescribed ones [dim * node], or
/// by more than these and its own size: only round-off or the facets of its surfaces held it. Tells
/// which and how; empty: there is none. A wedge or taper that steeply resists may move further.
base::OptionalFailure find_excessive_rigid_motion(const Discretisation& scene,
                                                  const std::vector<SubstructuredBody>& bodies,
                                                  const SolvedContactIncrement& solved,
                                                  const base::Vector& prescribed);

} // namespace spricka::analysis
