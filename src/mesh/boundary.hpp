// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace spricka::mesh {

/// Sides that belong to one element only, element by element, side by side.
std::vector<model::Face> boundary_faces(const model::Mesh& mesh);

/// Those of them that are surface of the body: without quadrilaterals inside that triangles meet,
/// and without these triangles (two on a diagonal of the quadrilateral, or four round a node in it;
/// what of theirs it has not is tied to it).
std::vector<model::Face> outer_surface_faces(const model::Mesh& mesh);

/// Boundary sides all of whose nodes lie in `nodes`, in the order of boundary_faces.
std::vector<model::Face> boundary_faces_with_all_nodes_in(const model::Mesh& mesh,
                                                          const std::vector<base::NodeId>& nodes);

/// Nodes of a side of an element, of an edge in the plane or a face in space: corners first.
struct FaceNodes {
  std::vector<base::NodeId> all;
  std::size_t corners = 3; ///< 2 of an edge

  [[nodiscard]] std::span<const base::NodeId> corner_nodes() const {
    return std::span(all).first(corners);
  }
  /// Corner i and the next.
  [[nodiscard]] std::pair<base::NodeId, base::NodeId> edge(std::size_t i) const {
    return {all[i], all[(i + 1) % corners]};
  }
  /// The middle of the edge from corner i to the next; invalid in linear elements. An edge has one.
  [[nodiscard]] base::NodeId mid_node(std::size_t i) const {
    return all.size() > corners ? all[corners + i] : base::NodeId();
  }
  /// The node in the middle of the face; invalid if it has none.
  [[nodiscard]] base::NodeId centre_node() const {
    return all.size() > 2 * corners ? all.back() : base::NodeId();
  }
};
FaceNodes face_nodes(const model::Mesh& mesh, const model::Face& face);

/// Whether all nodes of a face are marked in `inside` [node].
bool face_has_all_nodes_inside(const model::Mesh& mesh, const model::Face& face,
                               const std::vector<bool>& inside);

/// Nodes of some faces, ascending, each once.
std::vector<base::NodeId> nodes_of_faces(const model::Mesh& mesh,
                                         const std::vector<model::Face>& faces);

/// Edges of a face set strung into chains (2D). Each chain runs with the body on its left, as the
/// faces do; a closed chain (a bore) ends where it starts.
struct FaceChain {
  std::vector<model::Face> faces;
  bool closed = false;
};
/// Strings edges together from end to end: open chains from their free ends, then what is closed.
/// Every edge of `faces` is in one chain.
std::vector<FaceChain> build_face_chains(const model::Mesh& mesh,
                                         const std::vector<model::Face>& faces);

} // namespace spricka::mesh
