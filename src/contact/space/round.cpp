// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space/round.hpp"

#include <algorithm>
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

// Distance from a shape, positive outside, and its gradient.
struct DistanceAndGradient {
  double distance = 0.0;
  Vec3 gradient = Vec3::Zero();
};

DistanceAndGradient distance_and_gradient(const AnalyticShape& round, const Vec3& x) {
  switch (round.kind) {
  case AnalyticShapeKind::plane:
    return {(x - round.point).dot(round.axis), round.axis};
  case AnalyticShapeKind::sphere: {
    const Vec3 d = x - round.point;
    return {d.norm() - round.radius, d.normalized()};
  }
  case AnalyticShapeKind::cylinder:
  case AnalyticShapeKind::cone:
    break;
  }
  const AboutAxis at = about(round, x);
  const double slant = std::sqrt(1.0 + round.slope * round.slope);
  return {(at.radius - round.radius - round.slope * at.along) / slant,
          (at.radial - round.slope * round.axis) / slant};
}

} // namespace

double signed_distance(const AnalyticShape& round, const Vec3& x) {
  return distance_and_gradient(round, x).distance;
}

Vec3 distance_gradient(const AnalyticShape& round, const Vec3& x) {
  return distance_and_gradient(round, x).gradient;
}

Vec3 outer_normal(const AnalyticShape& round, const Vec3& x) {
  return round.sense * distance_gradient(round, x);
}

std::optional<double> distance_along_direction(const AnalyticShape& round, const Vec3& x,
                                               const Vec3& n) {
  constexpr int most_steps = 20;
  // Of the radius: what is left after a step is about its square, below round-off.
  constexpr double last_step = 1e-8;
  constexpr double round_off = 1e-15; // of places
  double g = 0.0;
  for (int i = 0; i < most_steps; ++i) {
    const Vec3 y = x + g * n;
    const DistanceAndGradient at = distance_and_gradient(round, y);
    const double along = at.gradient.dot(n);
    if (std::abs(along) < 0.5) {
      return std::nullopt;
    }
    const double step = at.distance / along;
    g -= step;
    if (round.kind == AnalyticShapeKind::plane ||
        std::abs(step) <= std::max(last_step * std::abs(round.radius), round_off * y.norm())) {
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
