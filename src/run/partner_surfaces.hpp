// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "estimate/edges.hpp"
#include "run/scene.hpp"
#include "run/step_solver.hpp"

#include <string>
#include <vector>

/// What surfaces of other bodies do to the error bars of a crack beside them.
namespace spricka::run {

/// A solved state and the edges of its mesh. All must outlive it.
struct PartnerSetting {
  const model::Model& model;
  const Scene& scene;
  const StepState& state;
  const estimate::EdgeTable& edges;
};

/// Why a closed contact or a TRANSITION beside a tip, where its crack does not start, takes the
/// bar: edges of one of its sides are longer than twice their distance from the tip, so that the
/// other body follows what the tip does to the surface too stiffly, which no error estimate of the
/// meshes sees. Empty: it does not.
std::string coarse_partner(const PartnerSetting& setting, const mesh::Tip& tip);

/// Nodes that another body or a rigid one holds by a BONDED contact, TRANSITION or RIGID. [node]
std::vector<bool> tied_nodes(const PartnerSetting& setting);

} // namespace spricka::run
