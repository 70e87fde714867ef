// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <numbers>
#include <string>

/// Mesh generators of $MESH. Each appends nodes, elements (labels from 1 on within the net) and
/// sets, named `prefix` + BODY and so on, to the mesh. Boundary sets are face sets.
namespace spricka::mesh {

struct BlockSpec {
  base::ElementType type = base::ElementType::quamc8;
  base::Vec3 origin = base::Vec3::Zero();
  base::Vec3 size = base::Vec3::Ones(); ///< LX LY LZ [length]
  int nx = 1, ny = 1, nz = 1;
  double bias = 1.0; ///< last over first element size along x
};
/// Sets BODY, XMIN XMAX YMIN YMAX; plane elements.
void generate_block(model::Mesh& mesh, base::NetId net, const std::string& prefix,
                    const BlockSpec& spec);
/// Sets BODY, XMIN XMAX YMIN YMAX ZMIN ZMAX; any type of solid: a cell of the block is a
/// hexahedron, two pentahedra along z or six tetrahedra.
void generate_solid_block(model::Mesh& mesh, base::NetId net, const std::string& prefix,
                          const BlockSpec& spec);

struct RingSpec {
  base::ElementType type = base::ElementType::quamc8;
  double x0 = 0.0, y0 = 0.0;
  double ri = 0.0, ro = 1.0; ///< ri = 0: disc, with triangles (or collapsed-free quads) inside
  double t0 = 0.0, t1 = 2.0 * std::numbers::pi; ///< [rad]; a full turn closes the ring
  int nr = 1, nt = 16;
  double bias = 1.0; ///< last over first element size from ri to ro
};
/// Sets BODY, INNER (not for a disc), OUTER. Nodes on the circles lie on them exactly.
void generate_ring(model::Mesh& mesh, base::NetId net, const std::string& prefix,
                   const RingSpec& spec);
/// Whether a disc of quadrilaterals can be of these alone; else it is of triangles.
bool divides_into_quadrilaterals(const RingSpec& disc);

struct LugSpec {
  base::ElementType type = base::ElementType::quamc8;
  double x0 = 0.0, y0 = 0.0; ///< centre of the bore
  double ri = 1.0;           ///< bore radius
  double ro = 2.0;           ///< radius of the head
  double ex = 0.0, ey = 0.0; ///< the head's centre as seen from the bore's
  double width = 4.0;        ///< W at END, at least 2 ro
  double length = 8.0;       ///< L, bore centre to END at x = x0 - L; the head points to +x
  int nr = 4, nt = 32;       ///< elements from the bore to the edge, and round the bore (8 or more)
};
/// Sides run from END as tangents to the head. Sets BODY, BORE, HEAD, SIDES, END.
void generate_lug(model::Mesh& mesh, base::NetId net, const std::string& prefix,
                  const LugSpec& spec);

struct PlateSpec {
  base::ElementType type = base::ElementType::quamc8;
  base::Vec3 origin = base::Vec3::Zero(); ///< corner
  base::Vec3 size = base::Vec3::Ones();   ///< LX LY 0 [length]
  base::Vec3 hole = base::Vec3::Zero();   ///< centre of the hole, within the plate
  double ri = 0.1;                        ///< its radius
  int nr = 4, nt = 32; ///< elements from the hole to a box about it, and round the hole (8 or more)
};
/// A rectangle with a round hole. Sets BODY, BORE, XMIN XMAX YMIN YMAX.
void generate_plate(model::Mesh& mesh, base::NetId net, const std::string& prefix,
                    const PlateSpec& spec);
/// Cells of the mesh that generate_plate would make; where there are more than 1e8 round the hole
/// these alone, none of them laid out.
double plate_cell_count(const PlateSpec& spec);

} // namespace spricka::mesh
