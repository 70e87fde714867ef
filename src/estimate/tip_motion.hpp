// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/extension.hpp"
#include "mesh/cut/cracked.hpp"

#include <vector>

/// The mesh round a tip moves on along with it: K of the moved mesh is K of a longer crack.
namespace spricka::estimate {

/// A field that moves the nodes of one tip, and how far for a central difference.
struct TipMeshMotion {
  std::size_t tip = 0;
  crack::VirtualExtensionField field;
  double step = 0.0; ///< [length] 1e-4 of the shortest side of an element that is strained
};

/// The motion of one tip by an extension field; its step follows from the elements of the field.
TipMeshMotion make_tip_mesh_motion(const mesh::CrackedMesh& cracked, std::size_t tip,
                                   crack::VirtualExtensionField field);

/// The mesh with the nodes of the motion moved by `by` steps along the tip's direction, the tip
/// along with them. Connectivity and sets stay.
mesh::CrackedMesh move_tip_mesh(const mesh::CrackedMesh& cracked, const TipMeshMotion& motion,
                                double by);

/// Whether the motion carries all nodes of these fields' elements along as one piece, or none.
bool moves_domains_rigidly(const model::Mesh& mesh, const TipMeshMotion& motion,
                           const std::vector<crack::VirtualExtensionField>& fields);

} // namespace spricka::estimate
