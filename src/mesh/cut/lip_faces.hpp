// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/cracked.hpp"

#include <vector>

namespace spricka::mesh {

/// The faces of a crack, from the mouth (or first tip) to the tip; one side is empty where the
/// crack lies on a symmetry line.
struct LipFaces {
  std::vector<model::Face> left, right;
};
LipFaces lip_faces(const model::Mesh& mesh, const CrackFaces& lips);

} // namespace spricka::mesh
