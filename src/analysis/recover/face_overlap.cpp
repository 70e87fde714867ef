// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/face_overlap.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

// Of the largest motion of one face against the other: round-off and the ripple of a mesh.
constexpr double least_crack_overlap = 1e-3;

} // namespace

std::string describe_face_overlap(const Discretisation& scene, const mesh::CrackFront& front,
                                  const StepState& state) {
  const mesh::CrackFaceNodes& faces = scene.cracked.faces[front.crack.index()];
  double deepest = 0.0;
  double largest = 0.0;
  std::size_t count = 0;
  const auto twins = faces.coincident_node_pairs();
  for (const auto& [upper, lower] : twins) {
    const base::Vec3 apart = state.u.segment<3>(3 * static_cast<Eigen::Index>(upper.index())) -
                             state.u.segment<3>(3 * static_cast<Eigen::Index>(lower.index()));
    const base::Vec3& x = scene.cracked.mesh.x[upper.index()];
    const double opening = apart.dot(front.curve->at(front.curve->nearest_length(x)).b);
    deepest = std::max(deepest, -opening);
    largest = std::max(largest, apart.norm());
    count += opening < 0.0 ? 1 : 0;
  }
  // A crack that is carried along moves by round-off.
  const bool still = largest <= 1e-9 * state.u.lpNorm<Eigen::Infinity>();
  if (still || deepest <= least_crack_overlap * largest) {
    return {};
  }
  return fmt::format("the faces of the crack overlap by up to {:.3g} at {} of {} pairs of nodes: K "
                     "is that of faces which pass through each other",
                     deepest, count, twins.size());
}

} // namespace spricka::analysis
