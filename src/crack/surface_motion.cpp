// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/surface_motion.hpp"

#include "model/mesh_side.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::crack {

using base::Vec3;

namespace {

constexpr double one_surface = 0.866; // cosine of 30 degrees, between normals of one smooth part
// Normals are taken this part of the way from the node to the middle of its side: at the end of a
// front that of a quarter-point side vanishes.
constexpr double into_side = 0.1;
// Sine of the angle at which a motion may still leave a surface: facets of a curved one.
constexpr double off_surface = 0.05;
// Cosine of the angle between a front and the normal of the surface, at least: c stays below 3.
constexpr double piercing = 0.3;

} // namespace

SurfaceNodeMotion::SurfaceNodeMotion(const model::Mesh& mesh, const std::vector<model::Face>& sides,
                                     const ObstructionTest& in_the_way) {
  for (const model::Face& face : sides) {
    const geometry::ElementSide side = model::element_side(mesh, face);
    for (int i = 0; i < static_cast<int>(side.nodes.size()); ++i) {
      const base::NodeId node = side.nodes[static_cast<std::size_t>(i)];
      if (!in_the_way(node, face)) {
        continue;
      }
      const shape::Point<2> at =
          (1.0 - into_side) * side.node_local_coordinates(i) + into_side * side.domain_centre();
      const Vec3 n = side.area_vector(at).normalized();
      std::vector<Vec3>& known = normals_[node];
      const auto alike = std::ranges::find_if(
          known, [&](const Vec3& sum) { return sum.normalized().dot(n) > one_surface; });
      if (alike == known.end()) {
        known.push_back(n);
      } else {
        *alike += n;
      }
    }
  }
}

std::optional<Vec3> SurfaceNodeMotion::admissible_motion(base::NodeId node, const Vec3& m,
                                                         const Vec3& t) const {
  const auto at = normals_.find(node);
  if (at == normals_.end()) {
    return m;
  }
  Vec3 blocking = Vec3::Zero();
  bool free = true;
  for (const Vec3& sum : at->second) {
    const Vec3 n = sum.normalized();
    free = free && std::abs(m.dot(n)) < 1e-9;
    if (std::abs(t.dot(n)) > std::abs(t.dot(blocking))) {
      blocking = n;
    }
  }
  if (free) {
    return m;
  }
  const bool pierced = std::abs(t.dot(blocking)) >= piercing;
  const Vec3 v = pierced ? Vec3(m - m.dot(blocking) / t.dot(blocking) * t) : m;
  const bool stays = std::ranges::all_of(at->second, [&](const Vec3& sum) {
    return std::abs(v.dot(sum.normalized())) <= off_surface * v.norm();
  });
  return stays ? std::optional(v) : std::nullopt;
}

} // namespace spricka::crack
