// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space/surface_projection.hpp"

#include "contact/space/opposite.hpp"
#include "shape/quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace spricka::contact {

namespace {

constexpr double least_piece = 1e-12; // of a triangle's area
constexpr double steepest = 0.17;     // cosine between both normals, 80 degrees
constexpr int piece_degree = 5;

std::array<Vec3, 3> corners_of(const FacetSurface& surface, const HatElement& t) {
  const geometry::SidePositions& X = surface.facets[t.facet].X;
  return {X.col(t.node[0]), X.col(t.node[1]), X.col(t.node[2])};
}

std::array<Vec2, 3> places_of(const FacetSurface& surface, const HatElement& t) {
  return hat_node_local_coordinates(surface.facets[t.facet], t.node);
}

Vec2 mixed(const std::array<Vec2, 3>& at, const Eigen::Vector3d& share) {
  return share[0] * at[0] + share[1] * at[1] + share[2] * at[2];
}

// How far along n the shape that a surface's nodes lie on is from a point of its faces.
double to_round(const FacetSurface& surface, std::size_t face, const Vec3& x, const Vec3& n) {
  const std::optional<AnalyticShape>& round = surface.analytic_shape(face);
  return round && round->exact ? distance_along_direction(*round, x, n).value_or(0.0) : 0.0;
}

} // namespace

// A triangle of the contact surface and the plane through its corners.
struct SurfaceProjector::Frame {
  const geometry::ElementSide& face;
  std::size_t number = 0; ///< of the face
  std::array<Vec3, 3> x;
  std::array<Vec2, 3> r; ///< of the corners on the face
  Vec3 e1, e2, n;
  PlaneTriangle flat;
  double area2 = 0.0;   ///< twice the area in the plane
  double r_area2 = 0.0; ///< the same in reference coordinates

  Frame(const FacetSurface& surface, const HatElement& t)
      : face(surface.facets[t.facet]), number(t.facet), x(corners_of(surface, t)),
        r(places_of(surface, t)) {
    const Vec3 across = (x[1] - x[0]).cross(x[2] - x[0]);
    n = across.normalized();
    e1 = (x[1] - x[0]).normalized();
    e2 = n.cross(e1);
    flat = {flat_place(x[0]), flat_place(x[1]), flat_place(x[2])};
    area2 = twice_area(flat);
    r_area2 = twice_area({r[0], r[1], r[2]});
  }
  [[nodiscard]] Vec2 flat_place(const Vec3& y) const {
    const Vec3 d = y - x[0];
    return {d.dot(e1), d.dot(e2)};
  }
  [[nodiscard]] double height(const Vec3& y) const { return (y - x[0]).dot(n); }
};

SurfaceProjector::SurfaceProjector(const FacetSurface& contact, const FacetSurface& target,
                                   double farther)
    : contact_(contact), target_(target), reach_(farthest_opposite * contact.extent + farther) {
  std::vector<geometry::Box<3>> boxes;
  for (const HatElement& t : target.elements) {
    corner_.push_back(corners_of(target, t));
    boxes.push_back(geometry::Box<3>::around(corner_.back()));
    size_ += boxes.back().diagonal() / static_cast<double>(target.elements.size());
  }
  tree_ = geometry::BoxTree<3>(boxes);
}

bool SurfaceProjector::meet(std::size_t face, PairPoint& point) const {
  constexpr int most_steps = 12;
  // In local coordinates: what is left after a step is about its square, below round-off.
  constexpr double last_step = 1e-9;
  constexpr double beyond = 0.3; // of a face's own size: rays beside it meet its continuation
  const geometry::ElementSide& target = target_.facets[face];
  double g = 0.0;
  double size = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most_steps && !(size < last_step); ++i) {
    const geometry::SidePoint y = target.point(point.s);
    Eigen::Matrix3d J;
    J << y.tangents, -point.normal;
    const Vec3 step = J.inverse() * (point.x + g * point.normal - y.x);
    if (!step.allFinite()) {
      return false;
    }
    point.s += step.head<2>();
    g += step[2];
    size = step.head<2>().norm();
  }
  const Vec3 back = target.area_vector(point.s);
  point.turn = -back.normalized().dot(point.normal);
  point.gap = zero_gap_below_round_off(g, point.x.cwiseAbs().maxCoeff());
  return size < 1e-6 && target.distance_outside(point.s) <= beyond && point.turn > 0.0 &&
         std::abs(g) <= reach_;
}

std::optional<SurfaceProjector::FlatView> SurfaceProjector::project_flat(const Frame& frame,
                                                                         std::size_t target) const {
  const std::array<Vec3, 3>& y = corner_[target];
  const std::array<double, 3> height{frame.height(y[0]), frame.height(y[1]), frame.height(y[2])};
  const auto [low, high] = std::ranges::minmax(height);
  if (low > reach_ || high < -reach_) {
    return std::nullopt;
  }
  // Seen from the contact surface a target that looks back runs clockwise.
  const PlaneTriangle flat{frame.flat_place(y[0]), frame.flat_place(y[2]), frame.flat_place(y[1])};
  // Nor does what is seen almost along itself: the side of a plug from its end.
  const double true_area2 = (y[1] - y[0]).cross(y[2] - y[0]).norm();
  if (twice_area(flat) <= std::max(least_piece * frame.area2, steepest * true_area2)) {
    return std::nullopt;
  }
  return FlatView{flat, intersect_triangles(frame.flat, flat)};
}

void SurfaceProjector::see_target(const Frame& frame, std::size_t target,
                                  OppositePointsOfElement& projection) const {
  const std::optional<FlatView> view = project_flat(frame, target);
  if (!view || view->seen.empty()) {
    return;
  }
  const auto& [flat, polygon] = *view;
  const HatElement& t = target_.elements[target];
  const std::array<Vec2, 3> s = places_of(target_, {t.facet, {t.node[0], t.node[2], t.node[1]}});
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    const PlaneTriangle piece{polygon[0], polygon[k], polygon[k + 1]};
    const double area2 = twice_area(piece);
    if (area2 <= least_piece * frame.area2) {
      continue;
    }
    bool met = false;
    for (const auto& [q, weight] : shape::triangle_rule(piece_degree)) {
      const Vec2 at = mixed(piece, {1.0 - q[0] - q[1], q[0], q[1]});
      PairPoint point;
      point.facet = frame.number;
      point.target = t.facet;
      point.hat = barycentric_coordinates(frame.flat, at);
      point.r = mixed(frame.r, point.hat);
      point.s = mixed(s, barycentric_coordinates(flat, at));
      const geometry::SidePoint here = frame.face.point(point.r);
      point.x = here.x;
      point.normal = surface_normal(contact_, frame.number, here);
      point.weight = weight * here.area_vector().norm() * area2 * frame.r_area2 / frame.area2;
      if (!meet(t.facet, point)) {
        projection.unprojected_area += point.weight;
        continue;
      }
      met = true;
      point.round_gap =
          point.gap - to_round(contact_, frame.number, point.x, point.normal) +
          to_round(target_, t.facet, point.x + point.gap * point.normal, point.normal);
      projection.points.push_back(point);
    }
    projection.flat_seen += met ? 0.5 * area2 : 0.0;
  }
}

std::optional<PairPoint> SurfaceProjector::project_along_normal(const Vec3& x,
                                                                const Vec3& n) const {
  // Twice as far each time: most points have the target right before them.
  for (double far = size_ > 0.0 ? std::min(size_, reach_) : reach_;;
       far = std::min(2.0 * far, reach_)) {
    std::optional<PairPoint> found = look_as_far(x, n, far);
    if ((found && std::abs(found->gap) <= far) || !(far < reach_)) {
      return found;
    }
  }
}

std::optional<PairPoint>
SurfaceProjector::project_along_normal(const Vec3& x, const Vec3& n,
                                       const PairQuadraturePoint& neighbour) const {
  const std::optional<PairPoint> met = meet_face(x, n, neighbour.target, neighbour.s);
  return met && std::abs(met->gap) <= size_ ? met : project_along_normal(x, n);
}

std::optional<PairPoint> SurfaceProjector::meet_face(const Vec3& x, const Vec3& n, std::size_t face,
                                                     const Vec2& s) const {
  constexpr double on = 1e-6; // of its reference coordinates
  PairPoint point;
  point.target = face;
  point.x = x;
  point.normal = n;
  point.s = s;
  return meet(face, point) && target_.facets[face].distance_outside(point.s) <= on
             ? std::optional(point)
             : std::nullopt;
}

std::optional<SurfaceProjector::TriangleOnLine>
SurfaceProjector::meet_plane_of(std::size_t triangle, const Vec3& x, const Vec3& n) const {
  const std::array<Vec3, 3>& y = corner_[triangle];
  Eigen::Matrix3d J;
  J << y[1] - y[0], y[2] - y[0], -n;
  const Vec3 b = J.inverse() * (x - y[0]);
  if (!b.allFinite()) {
    return std::nullopt;
  }
  return TriangleOnLine{triangle, {1.0 - b[0] - b[1], b[0], b[1]}, b[2]};
}

std::optional<PairPoint> SurfaceProjector::look_as_far(const Vec3& x, const Vec3& n,
                                                       double far) const {
  constexpr double near = 0.3; // of a triangle's size: the curved face may be met beside it
  const Vec3 up = far * n.cwiseAbs() + Vec3::Constant(near * size_);
  std::optional<PairPoint> found;
  const auto look_at = [&](const TriangleOnLine& at) {
    const HatElement& triangle = target_.elements[at.triangle];
    const std::optional<PairPoint> met =
        meet_face(x, n, triangle.facet, mixed(places_of(target_, triangle), at.share));
    if (met && (!found || std::abs(met->gap) < std::abs(found->gap))) {
      found = met;
    }
  };
  std::vector<TriangleOnLine> beside;
  for (const std::size_t t : tree_.boxes_intersecting({x - up, x + up})) {
    const std::optional<TriangleOnLine> at = meet_plane_of(t, x, n);
    if (!at || at->share.minCoeff() < -near) {
      continue;
    }
    if (at->share.minCoeff() < 0.0) {
      beside.push_back(*at);
    } else {
      look_at(*at);
    }
  }
  for (const TriangleOnLine& at : beside) {
    // Next to what was found they go on where it ends.
    if (!found || std::abs(at.gap) < std::abs(found->gap) - near * size_) {
      look_at(at);
    }
  }
  return found;
}

OppositePointsOfElement SurfaceProjector::project_triangle(const HatElement& triangle) const {
  const Frame frame(contact_, triangle);
  OppositePointsOfElement projection;
  projection.flat_area = 0.5 * frame.area2;
  visit_hat_quadrature_points(frame.face, triangle.node, piece_degree,
                              [&](const Vec3& hat, const Vec2& r, double weight) {
                                projection.whole += weight * frame.face.area_vector(r).norm() * hat;
                              });
  for (const std::size_t t : tree_.boxes_intersecting(prism(frame))) {
    see_target(frame, t, projection);
  }
  return projection;
}

bool SurfaceProjector::faces_any_of(const HatElement& triangle,
                                    const std::vector<bool>& faces) const {
  const Frame frame(contact_, triangle);
  return std::ranges::any_of(tree_.boxes_intersecting(prism(frame)), [&](std::size_t t) {
    if (!faces[target_.elements[t].facet]) {
      return false;
    }
    const std::optional<FlatView> view = project_flat(frame, t);
    return view && !view->seen.empty();
  });
}

// The box round the prism over a triangle, as far as a target may lie off.
geometry::Box<3> SurfaceProjector::prism(const Frame& frame) const {
  const Vec3 up = reach_ * frame.n.cwiseAbs();
  geometry::Box<3> box = geometry::Box<3>::around(frame.x);
  box.low -= up;
  box.high += up;
  return box;
}

} // namespace spricka::contact
