// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/set_border.hpp"

#include "shape/reference_element.hpp"
#include "shape/topology.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>

namespace spricka::deck {

namespace {

using base::Vec3;

std::vector<base::NodeId> nodes_of(const model::Mesh& mesh, const model::Face& face) {
  const std::span<const base::NodeId> all = mesh.element_nodes(face.element);
  std::vector<base::NodeId> nodes;
  for (const int i : shape::side_nodes(mesh.type[face.element.index()], face.side)) {
    nodes.push_back(all[static_cast<std::size_t>(i)]);
  }
  return nodes;
}

// Calls visit(x, area vector) at midpoints of a fine division of a face; in the plane the vectors
// are normals times lengths.
template <class Visit>
void for_midpoints(const model::Mesh& mesh, const model::Face& face, Visit&& visit) {
  const std::vector<base::NodeId> nodes = nodes_of(mesh, face);
  Eigen::Matrix3Xd X(3, nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    X.col(static_cast<Eigen::Index>(i)) = mesh.x[nodes[i].index()];
  }
  const base::ElementType type = mesh.type[face.element.index()];
  if (base::element_info(type).dim == 2) {
    constexpr int many = 64;
    const auto& line = shape::reference_line(static_cast<int>(nodes.size()));
    for (int i = 0; i < many; ++i) {
      const shape::Point<1> r((2.0 * i + 1.0) / many - 1.0);
      const Vec3 along = X * line.dN(r);
      visit(Vec3(X * line.N(r)), Vec3(2.0 / many * along.cross(Vec3::UnitZ())));
    }
    return;
  }
  constexpr int many = 16;
  const auto& side = shape::reference_element<2>(shape::solid_side_type(type, face.side));
  for (int i = 0; i < many; ++i) {
    for (int j = 0; j < many; ++j) {
      const double s = (i + 0.5) / many;
      const double t = (j + 0.5) / many;
      const bool triangle = side.domain == shape::ReferenceDomain::triangle;
      const shape::Point<2> r = triangle ? shape::Point<2>(s, t * (1.0 - s))
                                         : shape::Point<2>(2.0 * s - 1.0, 2.0 * t - 1.0);
      const double weight = (triangle ? 1.0 - s : 4.0) / (many * many);
      const Eigen::Matrix<double, 3, 2> J = X * side.dN(r);
      visit(Vec3(X * side.N(r)), Vec3(weight * J.col(0).cross(J.col(1))));
    }
  }
}

Vec3 normal_of(const model::Mesh& mesh, const model::Face& face) {
  Vec3 sum = Vec3::Zero();
  for_midpoints(mesh, face, [&](const Vec3& /*x*/, const Vec3& a) { sum += a; });
  return sum.normalized();
}

} // namespace

FaceSetCoverage face_set_coverage(const model::Mesh& mesh, const std::vector<model::Face>& kept,
                                  const std::vector<model::Face>& others,
                                  const std::function<bool(const base::Vec3&)>& holds) {
  constexpr double goes_on = 0.7; // cosine
  FaceSetCoverage border;
  std::map<base::NodeId, std::vector<Vec3>> normals;
  for (const model::Face& face : kept) {
    const Vec3 normal = normal_of(mesh, face);
    for (const base::NodeId n : nodes_of(mesh, face)) {
      normals[n].push_back(normal);
    }
    for_midpoints(mesh, face, [&](const Vec3& /*x*/, const Vec3& a) { border.taken += a.norm(); });
  }
  border.meant = border.taken;
  for (const model::Face& face : others) {
    const std::vector<base::NodeId> nodes = nodes_of(mesh, face);
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
