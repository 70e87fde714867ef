// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/opening.hpp"

#include <cmath>
#include <numbers>

namespace spricka::crack {

namespace {

using CrackFace = std::vector<base::NodeId>;

// The k-th node behind the tip.
base::NodeId behind(const CrackFace& crack_face, base::NodeId tip, std::size_t k) {
  // Faces run from the mouth to the tip; the first tip of an embedded crack stands at their start.
  return crack_face.back() == tip ? crack_face[crack_face.size() - 1 - k] : crack_face[k];
}

base::Vec2 at(const base::Vector& u, base::NodeId n) {
  return u.segment<2>(2 * static_cast<Eigen::Index>(n.index()));
}

} // namespace

std::optional<std::array<double, 3>> tip_K_from_face_opening(const TipContext& set,
                                                             const mesh::CrackedMesh& cracked,
                                                             const mesh::CrackFront& front,
                                                             const base::Vector& u) {
  if (front.crack.index() >= cracked.faces.size()) {
    return std::nullopt;
  }
  const mesh::CrackFaceNodes& crack_faces = cracked.faces[front.crack.index()];
  const bool half = front.symmetric_half;
  const CrackFace& one = crack_faces.meshed_face_nodes();
  if (one.size() < 3 || (!half && crack_faces.right.size() != one.size())) {
    return std::nullopt;
  }
  std::array<double, 2> r{};
  std::array<base::Vec2, 2> apart;
  for (std::size_t k = 0; k < 2; ++k) {
    const base::NodeId n = behind(one, front.tip_point().node, k + 1);
    // A quarter and the whole of the tip element, or a half where middle nodes stay.
    r[k] = (cracked.mesh.x[n.index()] - front.tip_point().x).norm();
    if (half) { // the other half is its mirror image
      const double up = crack_faces.left.empty() ? -1.0 : 1.0;
      const base::Vec2 opening = 2.0 * up * at(u, n);
      apart[k] = {0.0, opening.dot(set.tip.e2)};
    } else {
      // The tips of an embedded crack see its faces from opposite ends.
      const double turn = one.back() == front.tip_point().node ? 1.0 : -1.0;
      const base::Vec2 d =
          turn * (at(u, n) - at(u, behind(crack_faces.right, front.tip_point().node, k + 1)));
      apart[k] = {d.dot(set.tip.e1), d.dot(set.tip.e2)};
    }
  }
  // Of A sqrt(r) + B r the A (crack.27).
  const double denominator = std::sqrt(r[0]) * r[1] - std::sqrt(r[1]) * r[0];
  const base::Vec2 A = (apart[0] * r[1] - apart[1] * r[0]) / denominator;
  const double shear = set.material.E / (2.0 * (1.0 + set.material.nu));
  const double factor = shear * std::sqrt(2.0 * std::numbers::pi) /
                        (kolosov_constant(set.material.nu, set.state()) + 1.0);
  return std::array{factor * A.y(), factor * A.x(), 0.0};
}

} // namespace spricka::crack
