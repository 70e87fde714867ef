// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "fe/dof_map.hpp"
#include "model/mesh.hpp"

#include <string>

namespace spricka::analysis {

/// "direction X", "direction (0.6, 0.8)", "rotation", or a translation with rotation: what a rigid
/// motion, a nodal vector [dim * node], does with a body.
std::string describe_rigid_motion(const model::Mesh& mesh, const fe::Body& body,
                                  const base::Vector& motion);

} // namespace spricka::analysis
