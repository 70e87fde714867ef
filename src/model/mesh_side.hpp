// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "geometry/element_side.hpp"
#include "model/mesh.hpp"

/// Sides of the elements of a mesh.
namespace spricka::model {

/// Mesh nodes of a side, corners first.
inline std::vector<base::NodeId> side_nodes(const Mesh& mesh, const Face& face) {
  return geometry::side_nodes(mesh.type[face.element.index()], face.side,
                              mesh.element_nodes(face.element));
}

/// A side with the positions of its nodes.
inline geometry::ElementSide element_side(const Mesh& mesh, const Face& face) {
  geometry::ElementSide side(mesh.type[face.element.index()], face.side,
                             mesh.element_nodes(face.element), mesh.x);
  side.element = face.element;
  return side;
}

/// Which side of the mesh it is.
inline Face face_of(const geometry::ElementSide& side) {
  return {side.element, side.side};
}

} // namespace spricka::model
