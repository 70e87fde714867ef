// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/front_curve.hpp"
#include "model/cracks.hpp"

#include <vector>

/// Fronts of cracks in space that leave their plane: what such a crack has left behind.
namespace spricka::growth {

/// The crack's normals b at points of its front.
std::vector<base::Vec3> crack_normals(const model::CrackDefinition& crack,
                                      const std::vector<base::Vec3>& points);

/// The front history of a crack whose front has gone on: `before`, with its front there, from the
/// surface on straight on, and the front that it has made. Its normals are those of the way between
/// the two, or as they were where the front has not moved.
model::FrontHistory extend_front_history(const model::CrackDefinition& before,
                                         const mesh::FrontCurve& front,
                                         const mesh::FrontCurve& made);

} // namespace spricka::growth
