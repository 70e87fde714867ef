// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/forward.hpp"
#include "model/mesh.hpp"

#include <array>
#include <functional>

namespace spricka::fe {

/// The circle through the nodes of some edges and the side on which the body lies.
struct Bore {
  base::Vec2 centre = base::Vec2::Zero();
  double radius = 0.0;
  double side = 1.0; ///< 1: the body is outside (a bore), -1: inside (a shaft)
};

/// Fits a circle to the nodes of edges, see circle_fit.hpp.
Bore fit_bore(const model::Mesh& mesh, const std::vector<model::Face>& faces);

/// The axes across which planes of symmetry, of which one side is modelled, cut the faces of a
/// bearing load: there the image balances what the pressure does across the load [x y z].
std::array<bool, 3> mirror_cut_axes(const model::Model& model, const model::Mesh& mesh,
                                    const model::Load& load);

/// Adds the pressure of a pin on a bore, given by its resultant (Fx, Fy) [force], to the nodal
/// vector f. With theta measured from the load on the circle fitted to the faces, the pressure is
/// p0 cos(theta) (COSINE) or p0 (UNIFORM) for |theta| < 90 deg, radial, and scaled so that the
/// nodal forces sum to the resultant to round-off; a term p1 sin(theta), zero but for round-off
/// where the faces cover the half circle, takes up what an incomplete one would leave across the
/// load; not so where a mirror cuts them. Edges are divided where |theta| = 90 deg. Returns false,
/// with f unchanged, when the faces have no part in the loaded half.
bool add_bearing(const model::Model& model, const model::Mesh& mesh, const model::Load& load,
                 base::Vector& f);

/// The same pressure as forces at points: the face, where on it from -1 to 1, the force. Their sum
/// over any partition of unity on the faces is the resultant to round-off.
using BearingVisit = std::function<void(const model::Face&, double, const base::Vec2&)>;
/// Visits the points of the edges of a bore with the forces of the pin's pressure [force] there.
/// False, without a visit, when no edge lies in the loaded half; a load of zero visits nothing and
/// is true.
bool for_bearing_points(const model::Model& model, const model::Mesh& mesh, const model::Load& load,
                        const BearingVisit& visit);

/// The same on the faces of a cylinder in space, Fx Fy Fz across its axis, which is found from the
/// normals. The pressure is even along the axis. The loaded half ends inside faces where they fall
/// so: sums are exact, the distribution as good as the integration (degree 15). Returns false when
/// the load has a part along the axis or meets no face.
bool add_solid_bearing(const model::Model& model, const model::Mesh& mesh, const model::Load& load,
                       base::Vector& f);

/// The same pressure as forces at points: the face, the place on it (r, s, 0), the force.
using SolidBearingVisit =
    std::function<void(const model::Face&, const base::Vec3&, const base::Vec3&)>;
/// Visits the points of the faces of a cylindrical bore with the forces of the pin's pressure
/// [force] there. False where add_solid_bearing is; a load of zero visits nothing and is true.
bool for_solid_bearing_points(const model::Model& model, const model::Mesh& mesh,
                              const model::Load& load, const SolidBearingVisit& visit);

} // namespace spricka::fe
