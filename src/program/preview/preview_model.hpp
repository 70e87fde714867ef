// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "model/forward.hpp"
#include "results/preview.hpp"

#include <vector>

/// Parts of a preview that need a scene and no more.
namespace spricka::program {

/// Nets with their elements by type and freedoms by class.
std::vector<results::NetPreview> preview_nets(const model::Model& model,
                                              const analysis::Discretisation& scene);

/// The worst elements of the host and of the crack patches.
std::vector<results::WorstElementPreview>
preview_mesh_quality(const model::Model& model, const analysis::Discretisation& scene);

/// What the surfaces of each pair see of each other.
std::vector<results::ContactPairPreview>
preview_contact_pairs(const analysis::Discretisation& scene);

/// Mesh, tips and patches of one length; forecasts stay empty.
results::CrackLengthPreview preview_mesh_at_crack_length(const model::Model& model,
                                                         const analysis::Discretisation& scene);

} // namespace spricka::program
