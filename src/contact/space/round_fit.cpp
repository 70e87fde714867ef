// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space/round.hpp"

#include "base/dense_solve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace spricka::contact {

using base::Vec3;

namespace {

constexpr double is_round = 1e-4; // of the radius: what nodes may lie off
constexpr double is_exact = 1e-6;
constexpr double widest = 1e3; // extents

Vec3 mean_of(const std::vector<Vec3>& points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : points) {
    sum += p;
  }
  return sum / static_cast<double>(points.size());
}

// Eigenvector of the smallest eigenvalue of the second moments of vectors about a centre.
Vec3 least_direction(const std::vector<Vec3>& vectors, const Vec3& centre) {
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
  for (const Vec3& v : vectors) {
    moment += (v - centre) * (v - centre).transpose();
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moment).eigenvectors().col(0);
}

// Without the round-off of sums: the same shape when a crack has put other nodes on it.
double snapped(double x, double extent) {
  const double grid = std::ldexp(1.0, std::ilogb(extent) - 43);
  return grid * std::round(x / grid);
}

Vec3 snapped(const Vec3& x, double extent) {
  return {snapped(x.x(), extent), snapped(x.y(), extent), snapped(x.z(), extent)};
}

double farthest_off(const AnalyticShape& round, const std::vector<Vec3>& points) {
  double most = 0.0;
  for (const Vec3& p : points) {
    most = std::max(most, std::abs(signed_distance(round, p)));
  }
  return most;
}

std::optional<AnalyticShape> fit_plane(const std::vector<Vec3>& points, double extent) {
  AnalyticShape plane;
  plane.kind = AnalyticShapeKind::plane;
  const Vec3 mean = mean_of(points);
  Vec3 n = snapped(least_direction(points, mean), 1.0).normalized();
  Eigen::Index largest = 0;
  n.cwiseAbs().maxCoeff(&largest);
  n *= n[largest] < 0.0 ? -1.0 : 1.0;
  plane.axis = n;
  plane.point = snapped(mean.dot(n), extent) * n;
  plane.exact = true;
  return farthest_off(plane, points) <= is_exact * extent ? std::optional(plane) : std::nullopt;
}

// Kasa's fit: |x|^2 = 2 c.x + (r^2 - |c|^2) in the least-squares sense, about the mean. `across`:
// in the directions of these columns only, a sphere in three, a circle in two.
struct FittedSphere {
  Vec3 centre = Vec3::Zero();
  double radius = 0.0;
};
std::optional<FittedSphere> fit_ball(const std::vector<Vec3>& points, double extent,
                                     const Eigen::Matrix<double, 3, Eigen::Dynamic>& across) {
  const Vec3 mean = mean_of(points);
  const Eigen::Index dim = across.cols();
  Eigen::MatrixXd A(static_cast<Eigen::Index>(points.size()), dim + 1);
  base::Vector rhs(A.rows());
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    const base::Vector d =
        across.transpose() * (points[static_cast<std::size_t>(i)] - mean) / extent;
    A.row(i).head(dim) = 2.0 * d;
    A(i, dim) = 1.0;
    rhs[i] = d.squaredNorm();
  }
  if (base::column_rank(A, 1e-9) < dim + 1) {
    return std::nullopt; // points of a plane, or of a line
  }
  const base::Vector s = base::least_squares(A, rhs);
  const double square = s[dim] + s.head(dim).squaredNorm();
  return FittedSphere{mean + extent * (across * s.head(dim)),
                      extent * std::sqrt(std::max(0.0, square))};
}

std::optional<AnalyticShape> fit_sphere(const std::vector<Vec3>& points, double extent) {
  const std::optional<FittedSphere> ball = fit_ball(points, extent, Eigen::Matrix3d::Identity());
  if (!ball) {
    return std::nullopt;
  }
  AnalyticShape sphere;
  sphere.kind = AnalyticShapeKind::sphere;
  sphere.point = snapped(ball->centre, extent);
  sphere.radius = snapped(ball->radius, extent);
  return sphere;
}

// Distances to a cylinder or cone made least by Gauss and Newton: the point and the axis may move
// across the axis, the radius and, of a cone, the slope change.
void refine(const std::vector<Vec3>& points, AnalyticShape& round) {
  constexpr int most_steps = 30;
  const Eigen::Index unknowns = round.kind == AnalyticShapeKind::cone ? 6 : 5;
  Eigen::MatrixXd J(static_cast<Eigen::Index>(points.size()), unknowns);
  base::Vector r(J.rows());
  for (int step = 0; step < most_steps; ++step) {
    const Vec3 t1 = round.axis.unitOrthogonal();
    const Vec3 t2 = round.axis.cross(t1);
    for (Eigen::Index i = 0; i < J.rows(); ++i) {
      const Vec3 d = points[static_cast<std::size_t>(i)] - round.point;
      const double z = d.dot(round.axis);
      const Vec3 q = d - z * round.axis;
      const double rho = q.norm();
      const Vec3 e = rho > 0.0 ? Vec3(q / rho) : Vec3::Zero();
      r[i] = rho - round.radius - round.slope * z;
      const double tilt = -(z + round.slope * rho);
      J.row(i).head<5>() << -e.dot(t1), -e.dot(t2), tilt * e.dot(t1), tilt * e.dot(t2), -1.0;
      if (unknowns == 6) {
        J(i, 5) = -z;
      }
    }
    const base::Vector change = base::least_squares(J, base::Vector(-r));
    round.point += change[0] * t1 + change[1] * t2;
    round.axis = (round.axis + change[2] * t1 + change[3] * t2).normalized();
    round.radius += change[4];
    round.slope += unknowns == 6 ? change[5] : 0.0;
    if (!change.allFinite() || change.norm() <= 1e-15 * (1.0 + round.radius)) {
      break;
    }
  }
}

// The same shape by one set of numbers: the axis points up its largest part, a cone's the way it
// widens; the point is that nearest to the origin, of a cone too.
AnalyticShape tidied(AnalyticShape round, double extent) {
  Eigen::Index largest = 0;
  round.axis.cwiseAbs().maxCoeff(&largest);
  const bool reverse =
      round.kind == AnalyticShapeKind::cone ? round.slope < 0.0 : round.axis[largest] < 0.0;
  if (reverse) {
    round.axis = -round.axis;
    round.slope = -round.slope;
  }
  round.axis = snapped(round.axis, 1.0).normalized();
  const double back = round.point.dot(round.axis);
  round.point = snapped(round.point - back * round.axis, extent);
  round.radius = snapped(round.radius - round.slope * back, extent);
  round.slope = snapped(round.slope, 1.0);
  return round;
}

std::optional<AnalyticShape> fit_about_axis(AnalyticShapeKind kind, const std::vector<Vec3>& points,
                                            const std::vector<Vec3>& normals, double extent) {
  AnalyticShape round;
  round.kind = kind;
  // Normals of a cylinder lie in a plane across its axis, those of a cone end in one.
  const Vec3 about = kind == AnalyticShapeKind::cone ? mean_of(normals) : Vec3::Zero();
  round.axis = least_direction(normals, about);
  Eigen::Matrix<double, 3, 2> across;
  across.col(0) = round.axis.unitOrthogonal();
  across.col(1) = round.axis.cross(Vec3(across.col(0)));
  const std::optional<FittedSphere> ball = fit_ball(points, extent, across);
  if (!ball) {
    return std::nullopt;
  }
  round.point = ball->centre;
  round.radius = ball->radius;
  refine(points, round);
  return tidied(round, extent);
}

bool fits(const std::vector<Vec3>& points, double extent, AnalyticShape& round) {
  const double off = farthest_off(round, points);
  // A cone's radius at its point says nothing of its size.
  const double size = round.kind == AnalyticShapeKind::cone ? extent : round.radius;
  round.exact = off <= is_exact * size;
  return off <= is_round * size && size > 0.0 && size < widest * extent;
}

} // namespace

std::optional<AnalyticShape> fit_analytic_shape(const std::vector<Vec3>& points,
                                                const std::vector<PointNormal>& normals,
                                                double extent) {
  if (points.size() < 3 || normals.empty() || !(extent > 0.0)) {
    return std::nullopt;
  }
  std::optional<AnalyticShape> found = fit_plane(points, extent);
  const auto tried = [&](std::optional<AnalyticShape> round) {
    if (!found && round && fits(points, extent, *round)) {
      found = round;
    }
  };
  if (!found) {
    tried(fit_sphere(points, extent));
    std::vector<Vec3> directions;
    directions.reserve(normals.size());
    for (const PointNormal& at : normals) {
      directions.push_back(at.normal);
    }
    tried(fit_about_axis(AnalyticShapeKind::cylinder, points, directions, extent));
    tried(fit_about_axis(AnalyticShapeKind::cone, points, directions, extent));
  }
  double outward = 0.0;
  for (const PointNormal& at : normals) {
    outward += found ? at.normal.dot(distance_gradient(*found, at.x)) : 0.0;
  }
  if (found) {
    found->sense = outward < 0.0 ? -1.0 : 1.0;
  }
  return found;
}

} // namespace spricka::contact
