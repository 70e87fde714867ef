// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/lip_overlap.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::run {

namespace {

struct Jump {
  double overlap = 0.0; ///< at two neighbouring nodes, or next to a tip
  double lone = 0.0;    ///< at any node
  double largest = 0.0;
};

// Nodes from which a tip is an element away or less decide by themselves.
bool next_to_tip(const mesh::CrackedMesh::Lips& lips, std::size_t i) {
  const std::vector<base::NodeId>& path = lips.left.empty() ? lips.right : lips.left;
  const bool embedded =
      !lips.left.empty() && !lips.right.empty() && lips.left.front() == lips.right.front();
  return i + 3 >= path.size() || (embedded && i <= 2);
}

Jump look(const mesh::CrackedMesh& cracked, std::size_t line, const base::Vector& u) {
  const mesh::CrackedMesh::Lips& lips = cracked.lips[line];
  const std::vector<base::NodeId>& path = lips.left.empty() ? lips.right : lips.left;
  const auto displacement = [&](const std::vector<base::NodeId>& lip, std::size_t i) -> base::Vec2 {
    // the other face of a half model mirrors this one: what moves off the line opens
    return lip.empty() ? base::Vec2::Zero()
                       : base::Vec2(u.segment<2>(2 * static_cast<Eigen::Index>(lip[i].index())));
  };
  Jump jump;
  double before_it = 0.0; // overlap at the node before
  for (std::size_t i = 0; i < path.size(); ++i) {
    const base::Vec3& before = cracked.mesh.x[path[i == 0 ? 0 : i - 1].index()];
    const base::Vec3& after = cracked.mesh.x[path[std::min(i + 1, path.size() - 1)].index()];
    const base::Vec3 along = (after - before).normalized();
    const base::Vec2 left(-along.y(), along.x());
    const base::Vec2 apart = displacement(lips.left, i) - displacement(lips.right, i);
    // along the line of a half both faces go together
    const bool half = lips.left.empty() || lips.right.empty();
    jump.largest = std::max(jump.largest, half ? std::abs(apart.dot(left)) : apart.norm());
    const double here = std::max(0.0, -apart.dot(left));
    jump.lone = std::max(jump.lone, here);
    jump.overlap = std::max(jump.overlap, next_to_tip(lips, i) ? here : std::min(here, before_it));
    before_it = here;
  }
  return jump;
}

} // namespace

double lone_overlap(const mesh::CrackedMesh& cracked, std::size_t line, const base::Vector& u) {
  const Jump jump = look(cracked, line, u);
  return jump.largest > 0.0 ? jump.lone / jump.largest : 0.0;
}

double lip_overlap(const mesh::CrackedMesh& cracked, std::size_t line, const base::Vector& u) {
  const Jump jump = look(cracked, line, u);
  return jump.largest > 0.0 ? jump.overlap / jump.largest : 0.0;
}

double lip_jump(const mesh::CrackedMesh& cracked, std::size_t line, const base::Vector& u) {
  const mesh::CrackedMesh::Lips& lips = cracked.lips[line];
  const bool half = lips.left.empty() || lips.right.empty();
  return (half ? 2.0 : 1.0) * look(cracked, line, u).largest;
}

} // namespace spricka::run
