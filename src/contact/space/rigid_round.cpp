// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space/rigid_round.hpp"

#include "contact/space/opposite.hpp"

#include <cmath>

#include <Eigen/Geometry>

namespace spricka::contact {

namespace {

constexpr int triangle_degree = 7;

} // namespace

std::optional<AnalyticShape> rigid_target_shape(const model::RigidTarget& rigid) {
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
  case model::RigidTargetShape::plane:
    round.kind = AnalyticShapeKind::plane;
    break;
  case model::RigidTargetShape::line:
  case model::RigidTargetShape::arc:
    return std::nullopt;
  }
  round.axis = along.normalized();
  return round;
}

OppositePointsOfElement project_triangle_onto_rigid(const FacetSurface& contact,
                                                    const AnalyticShape& target,
                                                    const HatElement& triangle) {
  const geometry::ElementSide& face = contact.facets[triangle.facet];
  const double reach = farthest_opposite * contact.extent;
  OppositePointsOfElement projection;
  visit_hat_quadrature_points(
      face, triangle.node, triangle_degree, [&](const Vec3& hat, const Vec2& r, double weight) {
        PairPoint p;
        p.facet = triangle.facet;
        p.hat = hat;
        p.r = r;
        const geometry::SidePoint here = face.point(p.r);
        p.x = here.x;
        p.weight = weight * here.area_vector().norm();
        projection.whole += p.weight * p.hat;
        // A motion along the normal closes the gap.
        p.normal = -outer_normal(target, p.x);
        p.turn = here.area_vector().normalized().dot(p.normal);
        p.gap = zero_gap_below_round_off(target.sense * signed_distance(target, p.x),
                                         p.x.cwiseAbs().maxCoeff());
        p.round_gap = p.gap;
        if (const std::optional<AnalyticShape>& own = contact.analytic_shape(triangle.facet);
            own && own->exact) {
          // Where the faces were the shape they stand for: along the target's normal.
          p.round_gap -= distance_along_direction(*own, p.x, p.normal).value_or(0.0);
        }
        if (p.turn > 0.0 && std::abs(p.gap) <= reach) {
          projection.points.push_back(p);
        }
      });
  return projection;
}

} // namespace spricka::contact
