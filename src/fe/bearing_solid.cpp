// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/bearing.hpp"
#include "fe/circle_fit.hpp"
#include "fe/load_rule.hpp"
#include "model/loads.hpp"
#include "model/mesh_side.hpp"

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
  for (const model::Face& face : faces) {
    const geometry::ElementSide side = model::element_side(mesh, face);
    side.for_quadrature_points(load_degree, [&](const Vec2& r, double weight) {
      f(side.position(r), Vec3(weight * side.area_vector(r)));
    });
  }
}

// The direction that no normal has a part in: that of the axis.
Vec3 axis_of(const model::Mesh& mesh, const std::vector<model::Face>& faces) {
  Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
  for_points(mesh, faces, [&](const Vec3& /*x*/, const Vec3& a) {
    normals += a * a.transpose() / std::max(a.norm(), 1e-300);
  });
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(normals).eigenvectors().col(0);
}

// A pin in a hole: two unit vectors across its axis, the first along the load, and its centre
// there.
struct SolidPin {
  Vec3 along = Vec3::Zero();
  Vec3 across = Vec3::Zero();
  Vec2 centre = Vec2::Zero();
  bool cosine = true;
};

// Calls visit(face, r, main, across) at the points of the loaded half: the forces of the two unit
// pressures p = cos(theta) or 1, and p = sin(theta).
template <class Visit>
void for_pin_points(const model::Mesh& mesh, const std::vector<model::Face>& faces,
                    const SolidPin& pin, Visit&& visit) {
  for (const model::Face& face : faces) {
    const geometry::ElementSide side = model::element_side(mesh, face);
    for (const auto& point : shape::quadrature<2>(side.domain(), solid_pressure_degree)) {
      const Vec3 x = side.X * side.N(point.r);
      const Vec3 outward = side.area_vector(point.r);
      const Vec2 arm = Vec2(x.dot(pin.along), x.dot(pin.across)) - pin.centre;
      // Against the outer normal: away from the centre of a bore, towards that of a shaft.
      const Vec3 radial = (arm.x() * pin.along + arm.y() * pin.across).normalized();
      const Vec3 push = (outward.dot(radial) < 0.0 ? 1.0 : -1.0) * radial;
      const double c = push.dot(pin.along);
      if (c <= 0.0) {
        continue;
      }
      // The area of the face as it is seen along the radius.
      const Vec3 force = point.weight * std::abs(outward.dot(radial)) * push;
      visit(face, Vec3(point.r[0], point.r[1], 0.0), Vec3((pin.cosine ? c : 1.0) * force),
            Vec3(push.dot(pin.across) * force));
    }
  }
}

} // namespace

bool for_solid_bearing_points(const model::Model& model, const model::Mesh& mesh,
                              const model::Load& load, const SolidBearingVisit& visit) {
  assert(mesh.dim == 3 && load.value.size() == 3);
  const std::vector<model::Face>& faces = mesh.set_with_id(load.faces).faces;
  const Vec3 F(load.value[0](Vec3::Zero()), load.value[1](Vec3::Zero()),
               load.value[2](Vec3::Zero()));
  if (F.isZero(0.0)) {
    return true;
  }
  const Vec3 axis = axis_of(mesh, faces);
  if (std::abs(axis.dot(F)) > 1e-6 * F.norm()) {
    return false; // a pin pushes across its axis
  }
  SolidPin pin{F.normalized(), axis.cross(F.normalized()), Vec2::Zero(),
               load.shape == model::BearingShape::cosine};
  std::vector<WeightedPoint> points;
  for_points(mesh, faces, [&](const Vec3& x, const Vec3& a) {
    points.push_back({Vec2(x.dot(pin.along), x.dot(pin.across)), a.norm()});
  });
  pin.centre = fit_circle(points).centre;
  Eigen::Matrix2d total = Eigen::Matrix2d::Zero(); // column 0: sum of main, 1: of across
  for_pin_points(
      mesh, faces, pin,
      [&](const model::Face& /*face*/, const Vec3& /*r*/, const Vec3& main, const Vec3& across) {
        total.col(0) += Vec2(main.dot(pin.along), main.dot(pin.across));
        total.col(1) += Vec2(across.dot(pin.along), across.dot(pin.across));
      });
  const Eigen::FullPivLU<Eigen::Matrix2d> lu(total);
  if (!lu.isInvertible()) {
    return false;
  }
  const std::array<bool, 3> cuts = mirror_cut_axes(model, mesh, load);
  bool balanced = false; // by a plane along the load and the axis; one across the axis does nothing
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    balanced = balanced || (cuts.at(i) && std::abs(pin.across[static_cast<Eigen::Index>(i)]) > 0.5);
  }
  const Vec2 p = balanced ? Vec2(F.norm() / total(0, 0), 0.0) : Vec2(lu.solve(Vec2(F.norm(), 0.0)));
  for_pin_points(mesh, faces, pin,
                 [&](const model::Face& face, const Vec3& r, const Vec3& main, const Vec3& across) {
                   visit(face, r, p[0] * main + p[1] * across);
                 });
  return true;
}

bool add_solid_bearing(const model::Model& model, const model::Mesh& mesh, const model::Load& load,
                       Vector& f) {
  return for_solid_bearing_points(
      model, mesh, load, [&](const model::Face& face, const Vec3& r, const Vec3& force) {
        const geometry::ElementSide side = model::element_side(mesh, face);
        const auto N = side.N(r.head<2>());
        for (std::size_t i = 0; i < side.nodes.size(); ++i) {
          f.segment<3>(3 * static_cast<Eigen::Index>(side.nodes[i].index())) +=
              N[static_cast<Eigen::Index>(i)] * force;
        }
      });
}

} // namespace spricka::fe
