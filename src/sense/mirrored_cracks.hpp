// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/cracks.hpp"
#include "model/forward.hpp"
#include "sense/mirror.hpp"

#include <string>
#include <vector>

namespace spricka::sense {

/// Points of the line that a crack is drawn by: its own, the nodes of its path, and where it is
/// drawn by its mouth and an angle its end, `otherwise` [length] from the mouth where the crack has
/// no length.
std::vector<base::Vec3> crack_line_points(const model::Model& model,
                                          const model::CrackDefinition& crack, double otherwise);

/// Whether a load on the faces of a crack has the other as its image: pressures of cracks that are
/// images, alike at points of the crack and their images. Of tractions it is not asked.
bool is_mirrored_crack_face_load(const model::Model& model, const Reflection& mirror,
                                 const model::Load& one, const model::Load& other);

/// The crack that a load acts on the faces of; null: none.
const model::CrackDefinition* find_loaded_crack(const model::Model& model, const model::Load& load);

/// Whether each crack has a crack that is its mirror image, itself or another, and both grow or
/// neither; else what stands against it.
std::string crack_symmetry_obstacle(const model::Model& model, const Reflection& mirror);

} // namespace spricka::sense
