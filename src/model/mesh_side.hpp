// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "geometry/element_side.hpp"
#include "model/mesh.hpp"

#include <algorithm>

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

/// Sides of elements all of whose nodes are among some, element by element.
inline std::vector<Face> sides_with_all_nodes_in(const Mesh& mesh,
                                                 const std::vector<base::NodeId>& nodes) {
  std::vector<bool> inside(mesh.node_count(), false);
  for (const base::NodeId n : nodes) {
    inside[n.index()] = true;
  }
  std::vector<Face> sides;
  const auto is_inside = [&](base::NodeId n) { return inside[n.index()]; };
  for (std::size_t i = 0; i < mesh.element_count(); ++i) {
    const base::ElementId e(i);
    if (std::ranges::none_of(mesh.element_nodes(e), is_inside)) {
      continue;
    }
    for (int s = 0; s < base::element_info(mesh.type[i]).sides; ++s) {
      if (std::ranges::all_of(side_nodes(mesh, {e, s}), is_inside)) {
        sides.push_back({e, s});
      }
    }
  }
  return sides;
}

/// Which side of the mesh it is.
inline Face face_of_side(const geometry::ElementSide& side) {
  return {side.element, side.side};
}

} // namespace spricka::model
