// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_state.hpp"
#include "estimate/edges.hpp"

#include <string>
#include <vector>

/// What surfaces of other bodies do to the error bars of a crack beside them.
namespace spricka::analysis {

/// A solved state and the edges of its mesh. All must outlive it.
struct SolvedMeshState {
  const model::Model& model;
  const Discretisation& scene;
  const StepState& state;
  const estimate::EdgeTable& edges;
};

/// What closed contacts and TRANSITIONs beside a tip, where its crack does not start, do to its
/// bar. Where edges of one of the sides are long against their distance from the tip, the other
/// body follows what the tip does to the surface too stiffly, which no error estimate of the meshes
/// sees.
struct CoarseSurfaceEffect {
  double part = 0.0;   ///< of hypot(K1, K2), what it may be off by
  std::string why_not; ///< why there can be no bar; empty: `part` is all
};
/// Adds up over the mounted contacts and the TRANSITIONs what too coarse surfaces may do to K at a
/// tip in the plane.
CoarseSurfaceEffect coarse_surface_effect(const SolvedMeshState& setting,
                                          const mesh::CrackFront& front);

/// The same for a front in space, of the largest K along it, and of contacts alone: those that it
/// ends on as well, where edges count against its depth under the surface, and no length is too
/// long for a bar. `why_not` then is what to say of a part that is large.
CoarseSurfaceEffect coarse_surface_effect(const Discretisation& scene, const StepState& state,
                                          const FrontWithDomains& front);

/// Nodes that another body or a rigid one holds by a BONDED contact, TRANSITION or RIGID. [node]
std::vector<bool> tied_nodes(const SolvedMeshState& setting);

} // namespace spricka::analysis
