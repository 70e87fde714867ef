// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "results/preview.hpp"

#include <vector>

namespace spricka::sense {

/// Planes across an axis of the deck in which all bodies and materials are their own mirror image:
/// half a model does in those that supports, loads, contacts and cracks respect as well; for the
/// others, what stands against it. Meshes need not be mirrored, their boundaries must be
/// (`BoundaryPart`). Nothing is offered where that can't be told: equations between freedoms stand
/// against it.
std::vector<results::SymmetryPlanePreview> find_symmetry_planes(const model::Model& model);

/// The plane across one axis through the middle of all bodies, with what stands against it as a
/// mirror: the bodies themselves, or what find_symmetry_planes says.
results::SymmetryPlanePreview check_symmetry_across_axis(const model::Model& model, int axis);

/// Whether a load is its own mirror image: the same set, and the same values there.
bool is_symmetric_load(const model::Model& model, const model::Load& load,
                       const results::SymmetryPlanePreview& mirror);

} // namespace spricka::sense
