// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space/round.hpp"

#include <cmath>

#include <Eigen/Geometry>

namespace spricka::contact {

using base::Vec3;

namespace {

// A point about an axis: the part of its radius vector, that vector's length, the place along.
struct AboutAxis {
  Vec3 radial = Vec3::Zero(); ///< unit, zero on the axis
  double radius = 0.0;
  double along = 0.0;
};

AboutAxis about(const AnalyticShape& round, const Vec3& x) {
  const Vec3 d = x - round.point;
  AboutAxis at;
  at.along = d.dot(round.axis);
  const Vec3 q = d - at.along * round.axis;
  at.radius = q.norm();
  if (at.radius > 0.0) {
    at.radial = q / at.radius;
  }
  return at;
}

} // namespace

double signed_distance(const AnalyticShape& round, const Vec3& x) {
  switch (round.kind) {
  case AnalyticShapeKind::plane:
    return (x - round.point).dot(round.axis);
  case AnalyticShapeKind::sphere:
    return (x - round.point).norm() - round.radius;
  case AnalyticShapeKind::cylinder:
  case AnalyticShapeKind::cone:
    break;
  }
  const AboutAxis at = about(round, x);
  return (at.radius - round.radius - round.slope * at.along) / std::hypot(1.0, round.slope);
}

Vec3 distance_gradient(const AnalyticShape& round, const Vec3& x) {
  switch (round.kind) {
  case AnalyticShapeKind::plane:
    return round.axis;
  case AnalyticShapeKind::sphere:
    return (x - round.point).normalized();
  case AnalyticShapeKind::cylinder:
  case AnalyticShapeKind::cone:
    break;
  }
  return (about(round, x).radial - round.slope * round.axis) / std::hypot(1.0, round.slope);
}

Vec3 outer_normal(const AnalyticShape& round, const Vec3& x) {
  return round.sense * distance_gradient(round, x);
}

std::optional<double> distance_along_direction(const AnalyticShape& round, const Vec3& x,
                                               const Vec3& n) {
  constexpr int most_steps = 20;
  double g = 0.0;
  for (int i = 0; i < most_steps; ++i) {
    const Vec3 y = x + g * n;
    const double along = distance_gradient(round, y).dot(n);
    if (std::abs(along) < 0.5) {
      return std::nullopt;
    }
    const double step = signed_distance(round, y) / along;
    g -= step;
    if (std::abs(step) <= 1e-15 * (std::abs(round.radius) + y.norm())) {
      break;
    }
  }
  return g;
}

bool is_cylinder_or_cone(const AnalyticShape& round) {
  return round.kind == AnalyticShapeKind::cylinder || round.kind == AnalyticShapeKind::cone;
}

CylindricalCoordinates cylindrical_coordinates(const AnalyticShape& round, const Vec3& x) {
  if (!is_cylinder_or_cone(round)) {
    return {};
  }
  const bool along_x = std::abs(round.axis.x()) > 0.9;
  const Vec3 start = along_x ? Vec3::UnitY() : Vec3::UnitX();
  const Vec3 e1 = (start - start.dot(round.axis) * round.axis).normalized();
  const Vec3 e2 = round.axis.cross(e1);
  const Vec3 d = x - round.point;
  return {std::atan2(d.dot(e2), d.dot(e1)), d.dot(round.axis)};
}

} // namespace spricka::contact
