// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/load_visit.hpp"
#include "model/forward.hpp"

#include <array>

namespace spricka::fe {

/// The axes [x y z] across which planes of symmetry, of which one side is modelled, cut the faces
/// of a bearing load: there the image balances what the pressure does across the load.
std::array<bool, 3> mirror_cut_axes(const model::Model& model, const model::Mesh& mesh,
                                    const model::Load& load);

/// Visits the points of the faces of a bore or a shaft, face by face, with the forces of a pin's
/// pressure there [force], given by its resultant. With theta measured from the load on the circle
/// fitted to the faces, the pressure is p0 cos(theta) (COSINE) or p0 (UNIFORM) for |theta| < 90
/// deg, radial, and scaled so that forces over any partition of unity on the faces sum to the
/// resultant to round-off; a term p1 sin(theta), zero but for round-off where the faces cover the
/// half circle, takes up what an incomplete one would leave across the load; not so where a mirror
/// cuts them. In the plane edges are divided where |theta| = 90 deg. In space the axis is found
/// from the normals, the pressure is even along it, and where the loaded half ends inside faces the
/// distribution is as good as the integration (degree 15). False, without a visit, when no face has
/// a part in the loaded half or the load has one along the axis; a load of zero visits nothing and
/// is true.
bool for_bearing_points(const model::Model& model, const model::Mesh& mesh, const model::Load& load,
                        const LoadPointVisitor::FaceVisit& visit);

} // namespace spricka::fe
