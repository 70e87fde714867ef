// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space/twin_projection.hpp"

#include "geometry/box_tree.hpp"

#include <Eigen/Geometry>

namespace spricka::contact {

namespace {

// Hats times functions of second order times the Jacobian of quarter points.
constexpr int twin_degree = 5;

std::size_t corner_count(const geometry::ElementSide& face) {
  return static_cast<std::size_t>(face.corner_count());
}

// How far nodes that lie on one another may be apart by round-off, over the size of faces.
constexpr double twins_apart = 1e-6;

Vec3 centre_of(const geometry::ElementSide& face) {
  return face.X.leftCols(static_cast<Eigen::Index>(corner_count(face))).rowwise().mean();
}

// Where the corners of a face are on another one; nothing where they are not its corners.
std::optional<CoincidentFace> matched(const geometry::ElementSide& face,
                                      const geometry::ElementSide& other, double apart) {
  CoincidentFace twin;
  for (std::size_t c = 0; c < corner_count(face); ++c) {
    bool met = false;
    for (std::size_t k = 0; k < corner_count(face) && !met; ++k) {
      met = (face.X.col(static_cast<Eigen::Index>(c)) - other.X.col(static_cast<Eigen::Index>(k)))
                .norm() <= apart;
      twin.corner[c] = met ? face.node_local_coordinates(static_cast<int>(k)) : twin.corner[c];
    }
    if (!met) {
      return std::nullopt;
    }
  }
  return twin;
}

// Faces of one shape go onto one another by their corners alone: bilinear between four of them is
// linear, as the square is turned or mirrored.
Vec2 place_on_twin(const CoincidentFace& twin, std::size_t corners, const Vec2& r) {
  if (corners == 3) {
    return (1.0 - r[0] - r[1]) * twin.corner[0] + r[0] * twin.corner[1] + r[1] * twin.corner[2];
  }
  const double a = 0.5 * (1.0 + r[0]);
  const double b = 0.5 * (1.0 + r[1]);
  return (1.0 - a) * (1.0 - b) * twin.corner[0] + a * (1.0 - b) * twin.corner[1] +
         a * b * twin.corner[2] + (1.0 - a) * b * twin.corner[3];
}

} // namespace

std::optional<std::vector<CoincidentFace>> match_coincident_faces(const FacetSurface& own,
                                                                  const FacetSurface& other) {
  const double apart = twins_apart * own.mean_size;
  std::vector<geometry::Box<3>> boxes;
  for (const geometry::ElementSide& face : other.facets) {
    boxes.push_back({centre_of(face), centre_of(face)});
  }
  const geometry::BoxTree<3> tree(boxes);
  std::vector<CoincidentFace> twins;
  for (const geometry::ElementSide& face : own.facets) {
    const Vec3 centre = centre_of(face);
    std::optional<CoincidentFace> twin;
    for (const std::size_t f :
         tree.boxes_intersecting(geometry::Box<3>{centre, centre}.grown(apart))) {
      if (!twin && other.facets[f].nodes.size() == face.nodes.size()) {
        twin = matched(face, other.facets[f], apart);
        if (twin) {
          twin->face = f;
        }
      }
    }
    if (!twin) {
      return std::nullopt;
    }
    twins.push_back(*twin);
  }
  return twins;
}

OppositePointsOfElement project_triangle_on_matching_face(const FacetSurface& own,
                                                          const CoincidentFace& twin,
                                                          const HatElement& triangle) {
  const geometry::ElementSide& face = own.facets[triangle.facet];
  const std::size_t corners = corner_count(face);
  OppositePointsOfElement projection;
  visit_hat_quadrature_points(face, triangle.node, twin_degree,
                              [&](const Vec3& hat, const Vec2& r, double weight) {
                                PairPoint point;
                                point.facet = triangle.facet;
                                point.target = twin.face;
                                point.r = r;
                                point.s = place_on_twin(twin, corners, r);
                                point.hat = hat;
                                const geometry::SidePoint at = face.point(point.r);
                                point.x = at.x;
                                point.normal = surface_normal(own, triangle.facet, at);
                                point.turn = 1.0;
                                point.weight = weight * at.area_vector().norm();
                                projection.whole += point.weight * point.hat;
                                projection.flat_area += point.weight;
                                projection.points.push_back(point);
                              });
  projection.flat_seen = projection.flat_area;
  return projection;
}

} // namespace spricka::contact
