// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/circle_about_axis.hpp"
#include "geometry/circle_fit.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace spricka::geometry {

using base::Vec3;

Vec3 CircleAboutAxis::zero_direction() const {
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  const Vec3 towards = Vec3::Unit((largest + 1) % 3);
  return (towards - axis.dot(towards) * axis).normalized();
}

Vec3 CircleAboutAxis::point(double angle, double height) const {
  const Vec3 zero = zero_direction();
  return centre + height * axis +
         radius * (std::cos(angle) * zero + std::sin(angle) * axis.cross(zero));
}

double CircleAboutAxis::angle_of(const Vec3& point) const {
  const Vec3 zero = zero_direction();
  const Vec3 away = point - centre;
  return std::atan2(away.dot(axis.cross(zero)), away.dot(zero));
}

double CircleAboutAxis::height_of(const Vec3& point) const {
  return axis.dot(point - centre);
}

CircleAboutAxis fit_circle_about_axis(std::span<const Vec3> points, const Vec3& axis) {
  CircleAboutAxis circle;
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  circle.axis = (axis[largest] < 0.0 ? -1.0 : 1.0) * axis.normalized();
  const Vec3 u = circle.axis.unitOrthogonal();
  const Vec3 v = circle.axis.cross(u);
  std::vector<WeightedPoint> seen;
  double height = 0.0;
  for (const Vec3& x : points) {
    seen.push_back({{u.dot(x), v.dot(x)}, 1.0});
    height += circle.axis.dot(x) / static_cast<double>(points.size());
  }
  const FittedCircle flat = fit_circle(seen);
  circle.centre = flat.centre.x() * u + flat.centre.y() * v + height * circle.axis;
  circle.radius = std::isfinite(flat.radius) ? flat.radius : 0.0;
  for (const Vec3& x : points) {
    const Vec3 away = x - circle.centre;
    const double distance = (away - circle.axis.dot(away) * circle.axis).norm();
    circle.misfit = std::max(circle.misfit, std::abs(distance / circle.radius - 1.0));
  }
  return circle;
}

LeastSpread least_spread(std::span<const Vec3> vectors) {
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Vec3& x : vectors) {
    moments += x * x.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(moments);
  const auto ratio = [&](Eigen::Index i) {
    return std::sqrt(std::max(0.0, axes.eigenvalues()[i]) / axes.eigenvalues()[2]);
  };
  return {axes.eigenvectors().col(0), ratio(0), ratio(1)};
}

} // namespace spricka::geometry
