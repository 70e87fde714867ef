// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"

/// What loads and supports say of single nodes, held against the mesh with the cracks in it.
namespace spricka::analysis {

/// A force needs a node of an element or a tie, and a crack's patch must not have changed the nodes
/// that it acts on: E418, and false.
bool check_force_nodes(const model::Model& model, const Discretisation& scene,
                       base::Diagnostics& diagnostics);

/// No support or prescribed displacement may be lost with a node that a crack's patch cut out:
/// E419, and false.
bool check_supports_survive_cut(const model::Model& model, const Discretisation& scene,
                                base::Diagnostics& diagnostics);

} // namespace spricka::analysis
