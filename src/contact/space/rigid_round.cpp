// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space/rigid_round.hpp"

#include "contact/space/opposite.hpp"
#include "shape/quadrature.hpp"

#include <cmath>

#include <Eigen/Geometry>

namespace spricka::contact {

namespace {

constexpr int triangle_degree = 7;

} // namespace

AnalyticShape rigid_target_shape(const model::RigidTarget& rigid) {
  AnalyticShape round;
  round.point = rigid.first;
  round.exact = true;
  round.sense = rigid.radius < 0.0 || rigid.second_radius < 0.0 ? -1.0 : 1.0;
  round.radius = std::abs(rigid.radius);
  const Vec3 along = rigid.second - rigid.first;
  switch (rigid.shape) {
  case model::RigidTargetShape::sphere:
    round.kind = AnalyticShapeKind::sphere;
    return round;
  case model::RigidTargetShape::cylinder:
    round.kind = AnalyticShapeKind::cylinder;
    break;
  case model::RigidTargetShape::cone:
    round.kind = AnalyticShapeKind::cone;
    round.slope = (std::abs(rigid.second_radius) - round.radius) / along.norm();
    break;
  default:
    round.kind = AnalyticShapeKind::plane;
    break;
  }
  round.axis = along.normalized();
  return round;
}

ProjectedTriangle project_onto_rigid(const SpaceSurface& contact, const AnalyticShape& target,
                                     const SurfaceTriangle& triangle) {
  const geometry::ElementSide& face = contact.faces[triangle.face];
  const std::array<Vec2, 3> r = corner_coordinates(face, triangle.node);
  const Vec2 a = r[1] - r[0];
  const Vec2 b = r[2] - r[0];
  const double r_area2 = a.x() * b.y() - a.y() * b.x();
  const double reach = farthest_opposite * contact.extent;
  ProjectedTriangle projection;
  for (const auto& [q, weight] : shape::triangle_rule(triangle_degree)) {
    ProjectionPoint p;
    p.hat = Eigen::Vector3d(1.0 - q[0] - q[1], q[0], q[1]);
    p.r = r[0] + q[0] * a + q[1] * b;
    const geometry::SidePoint here = face.point(p.r);
    p.x = here.x;
    p.weight = weight * r_area2 * here.area_vector().norm();
    projection.whole += p.weight * p.hat;
    // A motion along the normal closes the gap.
    p.normal = -outer_normal(target, p.x);
    p.turn = here.area_vector().normalized().dot(p.normal);
    p.gap = zero_round_off(target.sense * distance_to(target, p.x), p.x.cwiseAbs().maxCoeff());
    p.round_gap = p.gap;
    if (const std::optional<AnalyticShape>& own = contact.analytic_shape(triangle.face);
        own && own->exact) {
      // Where the faces were the shape they stand for: along the target's normal.
      p.round_gap -= distance_along(*own, p.x, p.normal).value_or(0.0);
    }
    if (p.turn > 0.0 && std::abs(p.gap) <= reach) {
      projection.points.push_back(p);
    }
  }
  return projection;
}

} // namespace spricka::contact
