// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <array>
#include <vector>

namespace spricka::mesher {

/// The volumes of the model that gmsh holds, by rising number.
std::vector<int> model_volumes();

/// The faces of a volume, each once, by rising number.
std::vector<int> faces_of_volume(int volume);

/// Points of a face on an even grid of its parameters, as far as they lie on it [length of the
/// model]: about `apart` from each other, on every direction from 4 to 60.
struct FacePoints {
  std::vector<base::Vec3> points;
  double apart = 0.0; ///< what became of it
};
FacePoints points_inside_face(int face, double apart);

/// Points of the edges of a face, some on each edge, its ends among them.
std::vector<base::Vec3> points_of_face_edges(int face);

} // namespace spricka::mesher
