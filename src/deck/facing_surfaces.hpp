// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <cstddef>
#include <set>
#include <vector>

/// Surfaces that lie opposite each other, as sets of faces.
namespace spricka::deck {

using Faces = std::vector<model::Face>;

/// Two surfaces that are to meet, faces ascending; of a rigid one there are none.
struct FacingSurfaces {
  Faces one, two;
};

/// The faces of a set, ascending and each once.
Faces sorted_set_faces(const model::Mesh& mesh, base::FaceSetId set);
/// The faces that two lists have in common; all ascending.
Faces common_faces(const Faces& a, const Faces& b);
/// The faces, in their order, all of whose corners are among nodes.
Faces faces_with_all_corners_in(const model::Mesh& mesh, const Faces& faces,
                                const std::set<base::NodeId>& nodes);
/// The corners of all faces.
std::set<base::NodeId> face_corner_nodes(const model::Mesh& mesh, const Faces& faces);

/// How many faces of one pair lie opposite the same faces in another as well: of the faces that
/// both have, those whose nearest partner of either pair belongs to both.
std::size_t doubly_paired_face_count(const model::Mesh& mesh, const FacingSurfaces& a,
                                     const FacingSurfaces& b);

/// How many of some faces lie opposite those of another surface, not beyond its ends; all where it
/// has no faces.
std::size_t facing_face_count(const model::Mesh& mesh, const Faces& faces,
                              const Faces& opposite_faces);

} // namespace spricka::deck
