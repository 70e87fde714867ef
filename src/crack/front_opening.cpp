// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/front_opening.hpp"

#include "crack/stress_intensity.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace spricka::crack {

using base::NodeId;
using base::Vec3;

namespace {

// The node next to the front on the edge of these sides that goes back most straight from a point:
// the mid node of the edge, or its other end.
std::optional<NodeId> first_behind(const model::Mesh& mesh, const std::vector<model::Face>& sides,
                                   NodeId point, const Vec3& back) {
  constexpr double straight = 0.5; // cosine of the angle to -m, at least
  double best = straight;
  std::optional<NodeId> found;
  for (const model::Face& face : sides) {
    const base::ElementType type = mesh.type[face.element.index()];
    const std::span<const NodeId> nodes = mesh.element_nodes(face.element);
    const std::span<const int> side = shape::side_nodes(type, face.side);
    const std::size_t corners = shape::side_corner_count(type, face.side);
    const auto node = [&](std::size_t i) { return nodes[static_cast<std::size_t>(side[i])]; };
    for (std::size_t i = 0; i < corners; ++i) {
      const std::size_t next = (i + 1) % corners;
      if (node(i) != point && node(next) != point) {
        continue;
      }
      const NodeId other = node(i) == point ? node(next) : node(i);
      const double cosine = (mesh.x[other.index()] - mesh.x[point.index()]).normalized().dot(back);
      if (cosine > best) {
        best = cosine;
        found = side.size() > corners ? node(corners + i) : other;
      }
    }
  }
  return found;
}

} // namespace

std::optional<std::array<double, 3>> front_K_from_face_opening(const FrontContext& set,
                                                               const mesh::CrackFaceNodes& faces,
                                                               const mesh::FrontPoint& point,
                                                               double G, const base::Vector& u) {
  const FrontCoordinates at = set.axes.locate_point(point.x);
  const mesh::FrontFrame& frame = at.frame;
  const bool half = faces.left_sides.empty() || faces.right_sides.empty();
  const auto upper =
      first_behind(set.mesh, faces.left_sides.empty() ? faces.right_sides : faces.left_sides,
                   point.node, -frame.m);
  const auto lower = half ? upper : first_behind(set.mesh, faces.right_sides, point.node, -frame.m);
  if (!upper || !lower || !(G > 0.0)) {
    return std::nullopt;
  }
  const auto moved = [&](NodeId n) -> Vec3 {
    return u.segment<3>(3 * static_cast<Eigen::Index>(n.index()));
  };
  const double up = faces.left_sides.empty() ? -1.0 : 1.0;
  // Of a half model the other face is the mirror image.
  const Vec3 apart =
      half ? Vec3(2.0 * up * moved(*upper).dot(frame.b) * frame.b) : moved(*upper) - moved(*lower);
  const double r = (set.mesh.x[upper->index()] - point.x).norm();
  const double root = std::sqrt(2.0 * std::numbers::pi / r);
  std::array<double, 3> K{0.125 * set.E_effective() * root * apart.dot(frame.b),
                          0.125 * set.E_effective() * root * apart.dot(frame.m),
                          0.25 * set.body.mu * root * apart.dot(frame.t)};
  const double raw = energy_release_rate(set.E_effective(), set.body.mu, K);
  if (!(raw > 0.0)) {
    return std::nullopt;
  }
  for (double& k : K) {
    k *= std::sqrt(G / raw);
  }
  return K;
}

} // namespace spricka::crack
