// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <utility>
#include <vector>

/// What stands twice at one place: slips of whoever made the mesh.
namespace spricka::mesh {

/// Two sides of elements with corners at the same places but nodes of their own.
struct CoincidentFacePair {
  model::Face first;
  model::Face second;
};

/// Boundary sides that lie on each other, corner on corner within 1e-4 of the shortest boundary
/// side: nothing in the mesh joins the bodies there. In order of their first side.
std::vector<CoincidentFacePair> find_coincident_faces(const model::Mesh& mesh,
                                                      const std::vector<model::Face>& boundary);

/// Elements whose corners all stand where those of an earlier element do, each with that element.
std::vector<std::pair<base::ElementId, base::ElementId>> doubled_elements(const model::Mesh& mesh);

} // namespace spricka::mesh
