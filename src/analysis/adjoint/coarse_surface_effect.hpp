// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_state.hpp"
#include "estimate/edges.hpp"

#include <string>
#include <vector>

/// What surfaces of other bodies do to the error bars of a crack beside them.
namespace spricka::analysis {

/// A solved state and, in the plane, the edges of its mesh. All must outlive it.
struct SolvedMeshState {
  const model::Model& model;
  const Discretisation& scene;
  const StepState& state;
  const estimate::EdgeTable* edges = nullptr; ///< null: TRANSITIONs are left out
};

/// What closed contacts and TRANSITIONs beside a front do to its bars. Where edges or faces of one
/// of the sides are large the other body follows what the crack does to the surface too stiffly,
/// which no error estimate of the meshes sees. In the plane they count against their distance from
/// the tip, on surfaces where its crack does not start; in space against the depth of the front
/// under the surface, also where it ends on that.
struct CoarseNeighbourEffect {
  double part = 0.0; ///< of hypot(K1, K2), in space of the largest K, what it may be off by
  /// In the plane why there can be no bar, empty: `part` is all; in space what to say of a part
  /// that is large, as no size is too large for a bar.
  std::string why_not;
};
/// Adds up over the mounted contacts and the TRANSITIONs what too coarse surfaces may do to K of a
/// front; the reason is that of the first that has one.
CoarseNeighbourEffect estimate_coarse_neighbour_effect(const SolvedMeshState& set,
                                                       const mesh::CrackFront& front);

/// Nodes that another body or a rigid one holds by a BONDED contact, TRANSITION or RIGID. [node]
std::vector<bool> nodes_held_by_other_bodies(const SolvedMeshState& set);

} // namespace spricka::analysis
