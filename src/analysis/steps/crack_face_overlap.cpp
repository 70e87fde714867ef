// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/crack_face_overlap.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace spricka::analysis {

namespace {

// How far the nodes of two faces are apart against each other.
struct Jump {
  std::vector<double> overlap; ///< [node of the face, tips left out]
  double largest = 0.0;
};

Jump look(const mesh::CrackedMesh& cracked, std::size_t line, const base::Vector& u) {
  const mesh::CrackFaceNodes& crack_faces = cracked.faces[line];
  const bool half = crack_faces.has_one_face();
  const std::vector<base::NodeId>& path = crack_faces.meshed_face_nodes();
  const auto displacement = [&](const std::vector<base::NodeId>& crack_face,
                                std::size_t i) -> base::Vec2 {
    // the other face of a half model mirrors this one: what moves off the line opens
    return crack_face.empty()
               ? base::Vec2::Zero()
               : base::Vec2(u.segment<2>(2 * static_cast<Eigen::Index>(crack_face[i].index())));
  };
  Jump jump;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool tip = half ? i + 1 == path.size() : crack_faces.left[i] == crack_faces.right[i];
    if (tip) {
      continue;
    }
    const base::Vec3& before = cracked.mesh.x[path[i == 0 ? 0 : i - 1].index()];
    const base::Vec3& after = cracked.mesh.x[path[i + 1].index()];
    const base::Vec3 along = (after - before).normalized();
    const base::Vec2 left(-along.y(), along.x());
    const base::Vec2 apart = displacement(crack_faces.left, i) - displacement(crack_faces.right, i);
    // along the line of a half both faces go together
    jump.largest = std::max(jump.largest, half ? std::abs(apart.dot(left)) : apart.norm());
    jump.overlap.push_back(std::max(0.0, -apart.dot(left)));
  }
  return jump;
}

} // namespace

double find_shared_neighbour_overlap(std::span<const double> overlap) {
  const std::size_t n = overlap.size();
  double most = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    // Inside, one node alone is less than an element: the one before has to overlap as well.
    const bool at_end = i < 2 || i + 2 >= n;
    most = std::max(most, at_end ? overlap[i] : std::min(overlap[i - 1], overlap[i]));
  }
  return most;
}

RelativeCrackFaceOverlap measure_relative_face_overlap(const mesh::CrackedMesh& cracked,
                                                       std::size_t line, const base::Vector& u) {
  const Jump jump = look(cracked, line, u);
  if (jump.largest == 0.0) {
    return {};
  }
  return {find_shared_neighbour_overlap(jump.overlap) / jump.largest,
          *std::ranges::max_element(jump.overlap) / jump.largest};
}

double largest_crack_face_jump(const mesh::CrackedMesh& cracked, std::size_t line,
                               const base::Vector& u) {
  const mesh::CrackFaceNodes& crack_faces = cracked.faces[line];
  const bool half = crack_faces.has_one_face();
  // The mirrored face of a half model moves as far the other way.
  return (half ? 2.0 : 1.0) * look(cracked, line, u).largest;
}

} // namespace spricka::analysis
