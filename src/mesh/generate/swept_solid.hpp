// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <string>

namespace spricka::mesh {

/// How a plane mesh becomes a solid one.
struct SweepSpec {
  base::ElementType type = base::ElementType::hexec20; ///< of the solids
  double z0 = 0.0;                                     ///< of the lower face [length]
  double depth = 1.0;                                  ///< along z [length]
  int layers = 1;
};

/// The plane type that is swept along z for a solid type: quadrilaterals for hexahedra, triangles
/// for pentahedra and tetrahedra, of the same order.
base::ElementType swept_plane_type(base::ElementType solid);

/// Appends the solid elements that a plane mesh sweeps along z, each pentahedron of tetrahedra as
/// three. Sets: `prefix` + BODY, the face sets of the plane mesh (as the sides that its edges
/// sweep), ZMIN and ZMAX. A triangle among quadrilaterals becomes a pentahedron.
void sweep_plane_mesh(model::Mesh& mesh, base::NetId net, const std::string& prefix,
                      const model::Mesh& plane, const SweepSpec& spec);

} // namespace spricka::mesh
