// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/new_surface.hpp"

#include "shape/quadrature.hpp"
#include "shape/shape.hpp"

#include <Eigen/Geometry>

namespace spricka::mesh {

using base::Vec2;
using base::Vec3;

namespace {

constexpr int looked_at = 4;         // degree of the points
constexpr double least_facing = 0.3; // cosine between a triangle's normal and the host's

} // namespace

Vec3 triangle_normal(const RemeshedSurface& made, const RemeshedTriangle& triangle, const Vec2& r) {
  Eigen::Matrix<double, 3, 6> X;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    X.col(i) = made.points[static_cast<std::size_t>(triangle.points[k])].place.x;
    X.col(3 + i) = made.edges[static_cast<std::size_t>(triangle.edges[k])].mid.x;
  }
  const Eigen::Matrix<double, 3, 2> T = X * shape::Trimc6::dN(r);
  return T.col(0).cross(T.col(1));
}

SurfaceFailure find_remeshed_surface_fault(const SurfaceGeometry& surface,
                                           const RemeshedSurface& made) {
  std::vector<int> count(made.edges.size(), 0);
  for (const RemeshedTriangle& triangle : made.triangles) {
    const Vec3 outward = surface.place_at_coordinates(triangle.face, {1.0 / 3.0, 1.0 / 3.0}).normal;
    for (const auto& q : shape::triangle_rule(looked_at)) {
      const Vec3 n = triangle_normal(made, triangle, q.r);
      if (!(n.dot(outward) > least_facing * n.norm()) || !(n.norm() > 0.0)) {
        return {"the crack leaves the surface of the body too coarse or too narrow a place: a "
                "triangle folds",
                made.points[static_cast<std::size_t>(triangle.points[0])].place.x};
      }
    }
    for (const int e : triangle.edges) {
      ++count[static_cast<std::size_t>(e)];
    }
  }
  for (std::size_t e = 0; e < made.edges.size(); ++e) {
    const RemeshedEdgeKind kind = made.edges[e].kind;
    const int wanted = kind == RemeshedEdgeKind::rim || kind == RemeshedEdgeKind::outline ? 1 : 2;
    if (count[e] != wanted) {
      return {"the mesher left out an edge of the body's new surface", made.edges[e].mid.x};
    }
  }
  return {};
}

} // namespace spricka::mesh
