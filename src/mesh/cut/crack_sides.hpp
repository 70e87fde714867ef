// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/cracked.hpp"

#include <vector>

namespace spricka::mesh {

/// The faces of a crack, in the plane from the mouth (or first tip) to the tip; one side is empty
/// where the crack lies on a symmetry line.
struct CrackFaceSides {
  std::vector<model::Face> left, right;
};
CrackFaceSides crack_face_sides(const model::Mesh& mesh, const CrackFaces& crack_faces);

} // namespace spricka::mesh
