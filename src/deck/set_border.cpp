// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/set_border.hpp"

#include "model/mesh_side.hpp"
#include "shape/shape.hpp"

#include <algorithm>
#include <map>

namespace spricka::deck {

namespace {

using base::Vec3;

// Calls visit(x, area vector) at midpoints of a fine division of a face; in the plane the vectors
// are normals times lengths.
template <class Visit>
void for_midpoints(const model::Mesh& mesh, const model::Face& face, Visit&& visit) {
  const geometry::ElementSide side = model::element_side(mesh, face);
  const bool triangle = side.domain() == shape::ReferenceDomain::triangle;
  const int many = side.is_edge() ? 64 : 16;
  const int rows = side.is_edge() ? 1 : many;
  for (int i = 0; i < many; ++i) {
    for (int j = 0; j < rows; ++j) {
      const double s = (i + 0.5) / many;
      const double t = (j + 0.5) / rows;
      const base::Vec2 r =
          triangle ? base::Vec2(s, t * (1.0 - s)) : base::Vec2(2.0 * s - 1.0, 2.0 * t - 1.0);
      const double weight = triangle ? 1.0 - s : side.is_edge() ? 2.0 : 4.0;
      visit(side.position(r), Vec3(weight / (many * rows) * side.area_vector(r)));
    }
  }
}

Vec3 normal_of(const model::Mesh& mesh, const model::Face& face) {
  Vec3 sum = Vec3::Zero();
  for_midpoints(mesh, face, [&](const Vec3& /*x*/, const Vec3& a) { sum += a; });
  return sum.normalized();
}

} // namespace

FaceSetConditionAreas
face_set_condition_areas(const model::Mesh& mesh, const std::vector<model::Face>& kept,
                         const std::vector<model::Face>& others,
                         const std::function<bool(const base::Vec3&)>& holds) {
  constexpr double goes_on = 0.7; // cosine
  FaceSetConditionAreas border;
  std::map<base::NodeId, std::vector<Vec3>> normals;
  for (const model::Face& face : kept) {
    const Vec3 normal = normal_of(mesh, face);
    for (const base::NodeId n : model::side_nodes(mesh, face)) {
      normals[n].push_back(normal);
    }
    for_midpoints(mesh, face, [&](const Vec3& /*x*/, const Vec3& a) { border.taken += a.norm(); });
  }
  border.meant = border.taken;
  for (const model::Face& face : others) {
    const std::vector<base::NodeId> nodes = model::side_nodes(mesh, face);
    if (std::ranges::none_of(nodes, [&](base::NodeId n) { return normals.contains(n); })) {
      continue;
    }
    const Vec3 normal = normal_of(mesh, face);
    const bool next = std::ranges::any_of(nodes, [&](base::NodeId n) {
      const auto found = normals.find(n);
      return found != normals.end() && std::ranges::any_of(found->second, [&](const Vec3& other) {
               return normal.dot(other) > goes_on;
             });
    });
    if (next) {
      for_midpoints(mesh, face, [&](const Vec3& x, const Vec3& a) {
        border.meant += holds(x) ? a.norm() : 0.0;
      });
    }
  }
  return border;
}

} // namespace spricka::deck
