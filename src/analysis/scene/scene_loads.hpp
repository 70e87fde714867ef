// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "base/diagnostics.hpp"

/// Loads, prescribed displacements and temperatures of all cases on the mesh of a scene.
namespace spricka::analysis {

/// Fills the scene's columns by case; loads that do not arrive, contradictions with ties and nodes
/// that a crack has cut out go to `diagnostics`. Returns whether all is sound.
bool make_case_loads(const model::Model& model, Discretisation& scene,
                     base::Diagnostics& diagnostics);

/// Loads of all cases on independent freedoms [dim * node, case], T^T (f - K g): prescribed
/// displacements g load the others by their pull.
base::Matrix reduced_case_loads(const model::Model& model, const Discretisation& scene);

} // namespace spricka::analysis
