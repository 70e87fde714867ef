// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <vector>

namespace spricka::mesh {

/// Sides that belong to one element only, element by element, side by side.
std::vector<model::Face> boundary_faces(const model::Mesh& mesh);

/// Those of them that are surface of the body: without quadrilaterals inside that triangles meet,
/// and without these triangles (two on a diagonal of the quadrilateral, or four round a node in it;
/// what of theirs it has not is tied to it).
std::vector<model::Face> outer_faces(const model::Mesh& mesh);

/// Boundary sides all of whose nodes lie in `nodes`, in the order of boundary_faces.
std::vector<model::Face> faces_within(const model::Mesh& mesh,
                                      const std::vector<base::NodeId>& nodes);

/// Whether all nodes of a face are marked in `inside` [node].
bool lies_within(const model::Mesh& mesh, const model::Face& face, const std::vector<bool>& inside);

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
std::vector<FaceChain> build_chains(const model::Mesh& mesh, const std::vector<model::Face>& faces);

} // namespace spricka::mesh
