// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space/space_surface.hpp"

#include "contact/space/patches.hpp"
#include "model/mesh_side.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <Eigen/Geometry>

namespace spricka::contact {

namespace {

std::optional<AnalyticShape> shape_of(const model::Mesh& mesh, const SpaceSurface& surface,
                                      std::size_t part) {
  std::set<base::NodeId> nodes;
  std::vector<PointNormal> normals;
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    if (surface.part[f] == part) {
      const geometry::ElementSide& face = surface.faces[f];
      nodes.insert(face.nodes.begin(), face.nodes.end());
      const geometry::SidePoint centre = face.point(face.centre());
      normals.push_back({centre.x, centre.area_vector().normalized()});
    }
  }
  std::vector<Vec3> points;
  points.reserve(nodes.size());
  for (const base::NodeId n : nodes) {
    points.push_back(mesh.x[n.index()]);
  }
  return fit_analytic_shape(points, normals, surface.extent);
}

} // namespace

SpaceSurface make_space_surface(const model::Mesh& mesh, const std::vector<model::Face>& faces) {
  SpaceSurface surface;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  double area = 0.0;
  for (const model::Face& face : faces) {
    const geometry::ElementSide& own = surface.faces.emplace_back(model::element_side(mesh, face));
    low = low.cwiseMin(own.X.rowwise().minCoeff());
    high = high.cwiseMax(own.X.rowwise().maxCoeff());
    area += own.area();
    for (const FaceTriangle& nodes : face_triangles(own)) {
      surface.triangles.push_back({surface.faces.size() - 1, nodes});
    }
  }
  if (surface.faces.empty()) {
    return surface;
  }
  surface.extent = (high - low).norm();
  surface.mean_size = std::sqrt(area / static_cast<double>(surface.faces.size()));
  surface.part = smooth_parts(surface.faces);
  const std::size_t parts = *std::ranges::max_element(surface.part) + 1;
  for (std::size_t p = 0; p < parts; ++p) {
    surface.rounds.push_back(shape_of(mesh, surface, p));
  }
  return surface;
}

std::vector<SurfaceTriangle> corner_triangles(const SpaceSurface& surface) {
  std::vector<SurfaceTriangle> triangles;
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    for (const FaceTriangle& nodes : face_corner_triangles(surface.faces[f])) {
      triangles.push_back({f, nodes});
    }
  }
  return triangles;
}

Vec3 surface_normal(const SpaceSurface& surface, std::size_t face, const geometry::SidePoint& at) {
  Vec3 n = at.area_vector().normalized();
  const std::optional<AnalyticShape>& round = surface.analytic_shape(face);
  if (!round) {
    return n;
  }
  const Vec3 exact = outer_normal(*round, at.x);
  // On an axis or in a centre the shape has no normal; a face turned inside out keeps its own.
  return exact.dot(n) > 0.5 ? exact : n;
}

} // namespace spricka::contact
