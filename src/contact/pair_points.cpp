// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/pair_points.hpp"

#include "base/by_dimension.hpp"
#include "contact/rigid_target.hpp"
#include "contact/space/opposite.hpp"
#include "contact/space/rigid_round.hpp"
#include "contact/space/surface_projection.hpp"
#include "contact/space/twin_projection.hpp"
#include "shape/quadrature.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>
#include <utility>

namespace spricka::contact {

namespace {

constexpr int segment_degree = 9;
constexpr int segment_sampling_degree = 3;
constexpr int triangle_sampling_degree = 5;

// How far along n the circle that the nodes of a surface lie on is from a point of its edges.
double to_circle(const ContactSurface& surface, const Vec2& x, const Vec2& n) {
  if (!surface.circle || !surface.circle->exact) {
    return 0.0;
  }
  const Vec2 d = x - surface.circle->centre;
  const double along = d.normalized().dot(n);
  // Along a ray that is more than 60 degrees off the radius the circle is no measure.
  return std::abs(along) < 0.5 ? 0.0 : (surface.circle->radius - d.norm()) / along;
}

// What a point of a stretch meets; without its weight. None: the ray misses the target.
std::optional<PairPoint> project_point(const PairConstraints& pair, const MortarSegment& segment,
                                       double xi) {
  const Edge& edge = pair.contact.plane.edges[segment.contact_edge];
  const Vec2 x = point_on_edge(edge, xi);
  PairPoint point;
  point.facet = segment.contact_edge;
  point.r = {xi, 0.0};
  point.x = base::embed_in_space(x);
  Vec2 n = surface_normal(pair.contact, edge, xi);
  double on_target = 0.0; // circle of the target's, beyond its edge
  if (pair.rigid) {
    const std::optional<RigidProjection> foot = normal_projection(*pair.rigid, x);
    if (!foot) {
      return std::nullopt;
    }
    n = foot->normal;
    point.gap = foot->gap;
  } else {
    const Edge& target = pair.target.plane.edges[segment.target_edge];
    const std::optional<double> eta = ray_intersection(target, x, n);
    if (!eta) {
      return std::nullopt;
    }
    const Vec2 y = point_on_edge(target, *eta);
    point.target = segment.target_edge;
    point.s = {*eta, 0.0};
    point.gap = (y - x).dot(n);
    on_target = to_circle(pair.target, y, n);
  }
  point.normal = base::embed_in_space(n);
  point.gap = zero_gap_below_round_off(point.gap, x.cwiseAbs().maxCoeff());
  // (contact.7), and the same between the circles: each surface is moved onto its own.
  point.round_gap = point.gap - to_circle(pair.contact, x, n) + on_target;
  return point;
}

// What the points of a Gauss rule on a stretch meet, but for those that miss.
std::vector<PairPoint> project_segment(const PairConstraints& pair, const MortarSegment& segment,
                                       int degree) {
  const Edge& edge = pair.contact.plane.edges[segment.contact_edge];
  const double length = segment.to - segment.from;
  std::vector<PairPoint> points;
  for (const auto& [r, weight] : shape::line_rule(degree)) {
    const double xi = 0.5 * ((segment.to + segment.from) + length * r[0]);
    if (std::optional<PairPoint> point = project_point(pair, segment, xi)) {
      // (contact.12): the area that the point stands for.
      point->weight = 0.5 * length * weight * edge_tangent(edge, xi).norm() *
                      out_of_plane_depth(pair.contact, pair.target, point->x.head<2>());
      points.push_back(*point);
    }
  }
  return points;
}

// What the edges of a contact surface meet, edge or half edge one by one.
class SegmentProjection {
public:
  SegmentProjection(const PairConstraints& pair, int degree)
      : pair_(pair), degree_(degree), segments_(find_mortar_segments(pair)) {}

  [[nodiscard]] OppositePointsOfElement project(const HatElement& element) const {
    const geometry::ElementSide& edge = pair_.contact.facets[element.facet];
    const double from = edge.node_local_coordinates(element.node[0])[0];
    const double to = edge.node_local_coordinates(element.node[1])[0];
    OppositePointsOfElement found;
    found.whole = whole_hats(element);
    const auto first =
        std::ranges::lower_bound(segments_, element.facet, {}, &MortarSegment::contact_edge);
    const auto end =
        std::ranges::upper_bound(segments_, element.facet, {}, &MortarSegment::contact_edge);
    for (auto s = first; s != end; ++s) {
      // Segments of an edge stand in the order of `from`; neighbours that share a node may overlap
      // by round-off.
      if (s != first && s->from < std::prev(s)->to - 1e-6) {
        found.trouble = "the surfaces face each other twice at one place (folded or cornered "
                        "surfaces are not available in this version)";
      }
      if (const double middle = 0.5 * (s->from + s->to); middle < from || middle > to) {
        continue;
      }
      std::vector<PairPoint> points = project_segment(pair_, *s, degree_);
      // Their area would be lost.
      if (points.size() < shape::line_rule(degree_).size()) {
        found.trouble = "the normals of one surface miss the other within a stretch that faces it "
                        "(too strongly curved for its edges?)";
      }
      for (PairPoint& p : points) {
        const double part = (p.r[0] - from) / (to - from);
        p.hat = {1.0 - part, part, 0.0};
        found.points.push_back(p);
      }
    }
    return found;
  }

private:
  [[nodiscard]] Vec3 whole_hats(const HatElement& element) const {
    const geometry::ElementSide& edge = pair_.contact.facets[element.facet];
    Vec3 whole = Vec3::Zero();
    visit_hat_quadrature_points(
        edge, element.node, degree_, [&](const Vec3& hat, const Vec2& r, double weight) {
          const geometry::SidePoint at = edge.point(r);
          whole += weight * at.area_vector().norm() *
                   out_of_plane_depth(pair_.contact, pair_.target, at.x.head<2>()) * hat;
        });
    return whole;
  }

  const PairConstraints& pair_;
  int degree_;
  std::vector<MortarSegment> segments_;
};

// What the points of one rule on a whole triangle meet.
OppositePointsOfElement sample_triangle(const ContactSurface& own, const SurfaceProjector& target,
                                        const HatElement& triangle) {
  const geometry::ElementSide& face = own.facets[triangle.facet];
  OppositePointsOfElement found;
  visit_hat_quadrature_points(face, triangle.node, triangle_sampling_degree,
                              [&](const Vec3& hat, const Vec2& r, double weight) {
                                const geometry::SidePoint here = face.point(r);
                                const Vec3 n = surface_normal(own, triangle.facet, here);
                                std::optional<PairPoint> met =
                                    found.points.empty() ? target.project_along_normal(here.x, n)
                                                         : target.project_along_normal(
                                                               here.x, n, found.points.back());
                                if (met) {
                                  met->facet = triangle.facet;
                                  met->hat = hat;
                                  met->r = r;
                                  met->weight = weight * here.area_vector().norm();
                                  found.points.push_back(*met);
                                }
                              });
  return found;
}

ElementProjector edge_projector(const PairConstraints& pair, ProjectionPointDensity rule) {
  const int degree =
      rule == ProjectionPointDensity::sampling ? segment_sampling_degree : segment_degree;
  return [edges = SegmentProjection(pair, degree)](const HatElement& element) {
    return edges.project(element);
  };
}

ElementProjector face_projector(const PairConstraints& pair, ProjectionPointDensity rule) {
  const ContactSurface& own = pair.contact;
  const bool sampled = rule == ProjectionPointDensity::sampling;
  if (pair.faces) {
    const std::optional<std::vector<CoincidentFace>> twins =
        match_coincident_faces(own, pair.target);
    assert(twins);
    return [&own, twins = *twins](const HatElement& triangle) {
      return project_triangle_on_matching_face(own, twins[triangle.facet], triangle);
    };
  }
  if (pair.rigid_shape) {
    return [&own, shape = *pair.rigid_shape](const HatElement& triangle) {
      return project_triangle_onto_rigid(own, shape, triangle);
    };
  }
  // A std::function can be copied, the tree of a SurfaceProjector can't.
  return [&own, sampled, target = std::make_shared<SurfaceProjector>(own, pair.target)](
             const HatElement& triangle) {
    return sampled ? sample_triangle(own, *target, triangle) : target->project_triangle(triangle);
  };
}

} // namespace

std::vector<MortarSegment> find_mortar_segments(const PairConstraints& pair) {
  return pair.rigid ? find_mortar_segments(pair.contact, *pair.rigid)
                    : find_mortar_segments(pair.contact, pair.target);
}

std::optional<double> gap_to_rigid_target(const PairConstraints& pair, const Vec3& x) {
  if (pair.rigid_shape) {
    return pair.rigid_shape->sense * signed_distance(*pair.rigid_shape, x);
  }
  const std::optional<RigidProjection> foot = normal_projection(*pair.rigid, x.head<2>());
  return foot && !foot->beyond ? std::optional(foot->gap) : std::nullopt;
}

ElementProjector make_target_projector(const PairConstraints& pair, ProjectionPointDensity rule) {
  constexpr base::ByDimension projectors{edge_projector, face_projector};
  return projectors.at(pair.contact.dim)(pair, rule);
}

} // namespace spricka::contact
