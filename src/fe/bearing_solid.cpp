// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/bearing.hpp"
#include "fe/circle_fit.hpp"
#include "fe/face.hpp"
#include "model/loads.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cmath>

namespace spricka::fe {

namespace {

using base::Vec2;
using base::Vec3;
using base::Vector;

// Pressures are no polynomials, and the loaded half may end inside a face.
constexpr int solid_pressure_degree = 15;

// Calls f(x, a) with each integration point of the faces and its outward area vector.
template <class F>
void for_points(const model::Mesh& mesh, const std::vector<model::Face>& faces, F&& f) {
  for_faces(mesh, faces, [&]<shape::Shape Side>(Side, const model::Face& face) {
    const SideNodes<Side> X = side_coordinates<Side>(mesh, face);
    for (const auto& point : shape::quadrature<Side>(load_degree)) {
      const Vec3 a = point.weight * area_vector<Side>(X, point.r);
      f(Vec3(X * Side::N(point.r)), a);
    }
  });
}

// The direction that no normal has a part in: that of the axis.
Vec3 axis_of(const model::Mesh& mesh, const std::vector<model::Face>& faces) {
  Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
  for_points(mesh, faces, [&](const Vec3& /*x*/, const Vec3& a) {
    normals += a * a.transpose() / std::max(a.norm(), 1e-300);
  });
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(normals).eigenvectors().col(0);
}

// Two unit vectors across the axis, the first along the load.
struct Frame {
  Vec3 along = Vec3::Zero();
  Vec3 across = Vec3::Zero();
};

} // namespace

bool add_solid_bearing(const model::Mesh& mesh, const model::Load& load, Vector& f) {
  assert(mesh.dim == 3 && load.value.size() == 3);
  const std::vector<model::Face>& faces = mesh.set(load.faces).faces;
  const Vec3 F(load.value[0](Vec3::Zero()), load.value[1](Vec3::Zero()),
               load.value[2](Vec3::Zero()));
  if (F.isZero(0.0)) {
    return true;
  }
  const Vec3 axis = axis_of(mesh, faces);
  if (std::abs(axis.dot(F)) > 1e-6 * F.norm()) {
    return false; // a pin pushes across its axis
  }
  const Frame frame{F.normalized(), axis.cross(F.normalized())};
  std::vector<WeightedPoint> points;
  for_points(mesh, faces, [&](const Vec3& x, const Vec3& a) {
    points.push_back({Vec2(x.dot(frame.along), x.dot(frame.across)), a.norm()});
  });
  const Vec2 centre = fit_circle(points).centre;
  const bool cosine = load.shape == model::BearingShape::cosine;

  Vector main = Vector::Zero(f.size());
  Vector across = Vector::Zero(f.size());
  Eigen::Matrix2d total = Eigen::Matrix2d::Zero(); // column 0: sum of main, 1: of across
  for_faces(mesh, faces, [&]<shape::Shape Side>(Side, const model::Face& face) {
    const SideNodes<Side> X = side_coordinates<Side>(mesh, face);
    const std::array<base::NodeId, Side::nodes> nodes = nodes_of_face<Side>(mesh, face);
    for (const auto& point : shape::quadrature<Side>(solid_pressure_degree)) {
      const Eigen::Matrix<double, Side::nodes, 1> N = Side::N(point.r);
      const Vec3 x = X * N;
      const Vec3 outward = area_vector<Side>(X, point.r);
      const Vec2 arm = Vec2(x.dot(frame.along), x.dot(frame.across)) - centre;
      // Against the outer normal: away from the centre of a bore, towards that of a shaft.
      const Vec3 radial = (arm.x() * frame.along + arm.y() * frame.across).normalized();
      const Vec3 push = (outward.dot(radial) < 0.0 ? 1.0 : -1.0) * radial;
      const double c = push.dot(frame.along);
      if (c <= 0.0) {
        continue;
      }
      // The area of the face as it is seen along the radius.
      const Vec3 force = point.weight * std::abs(outward.dot(radial)) * push;
      const double p = cosine ? c : 1.0;
      const double q = push.dot(frame.across);
      const Vec2 plane(force.dot(frame.along), force.dot(frame.across));
      total.col(0) += p * plane;
      total.col(1) += q * plane;
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Vec3 share = N[static_cast<Eigen::Index>(i)] * force;
        const auto row = 3 * static_cast<Eigen::Index>(nodes[i].index());
        main.segment<3>(row) += p * share;
        across.segment<3>(row) += q * share;
      }
    }
  });
  const Eigen::FullPivLU<Eigen::Matrix2d> lu(total);
  if (!lu.isInvertible()) {
    return false;
  }
  const Vec2 p = lu.solve(Vec2(F.norm(), 0.0));
  f += p[0] * main + p[1] * across;
  return true;
}

} // namespace spricka::fe
