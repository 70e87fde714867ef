// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/bearing.hpp"

#include "base/by_dimension.hpp"
#include "fe/load_rule.hpp"
#include "geometry/circle_fit.hpp"
#include "model/mesh_side.hpp"
#include "model/model.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

namespace spricka::fe {

namespace {

using base::Vec2;
using base::Vec3;
using geometry::ElementSide;

// Pressures are no polynomials, and the loaded half may end inside a face in space.
constexpr int pressure_degree = 15;

/// A pin and the circle that it touches, in a plane across its axis.
struct Pin {
  Eigen::Matrix<double, 3, 2> axes; ///< columns: of that plane, the x and y of what follows
  geometry::FittedCircle circle;
  double side = 1.0;         ///< of edges; 1: the body is outside (a bore), -1: inside (a shaft)
  Vec2 force = Vec2::Zero(); ///< the resultant [force]
  Vec2 d = Vec2::Zero();     ///< unit vector along it
  bool cosine = true;        ///< p = cos(theta), else 1

  [[nodiscard]] Vec2 across() const { return {-d.y(), d.x()}; }
  /// From the centre to a place.
  [[nodiscard]] Vec2 arm(const Vec3& x) const { return axes.transpose() * x - circle.centre; }
};

// Places on [-1, 1], both ends included, where an edge crosses the diameter across the load.
struct Cuts {
  std::array<double, 4> at{-1.0};
  std::size_t count = 1;

  void add(double r) {
    if (r > at[count - 1] && r < 1.0) {
      at[count++] = r;
    }
  }
};

// Roots of the distance q(r) = (x(r) - centre) . d, a polynomial of degree <= 2 given by its values
// at -1, 0, 1.
Cuts cut_edge(double left, double middle, double right) {
  const double a = 0.5 * (left + right) - middle;
  const double b = 0.5 * (right - left);
  const double c = middle;
  Cuts cuts;
  const double discriminant = b * b - 4.0 * a * c;
  if (discriminant >= 0.0) {
    // The form without cancellation; a vanishing denominator means no root within reach.
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    const double r1 = a != 0.0 ? q / a : 2.0;
    const double r2 = q != 0.0 ? c / q : 0.0;
    // In ascending order, as add() wants them.
    cuts.add(std::min(r1, r2));
    cuts.add(std::max(r1, r2));
  }
  cuts.at[cuts.count++] = 1.0;
  return cuts;
}

// Calls visit(r, push, area) at the points of a side: the unit vector that the pressure has there
// and the area on which it acts, of the exact arc of an edge, of a face as it is seen along the
// radius.
template <class Visit>
void for_points_on_edge(const Pin& pin, const ElementSide& edge, double thickness, Visit&& visit) {
  const auto arm_at = [&](double r) { return pin.arm(edge.position({r, 0.0})); };
  // Along the load from the centre: its zeros are where |theta| = 90 degrees.
  const auto distance_at = [&](double r) { return arm_at(r).dot(pin.d); };
  const Cuts cuts = cut_edge(distance_at(-1.0), distance_at(0.0), distance_at(1.0));
  for (std::size_t k = 0; k + 1 < cuts.count; ++k) {
    const double middle = 0.5 * (cuts.at[k] + cuts.at[k + 1]);
    const double half = 0.5 * (cuts.at[k + 1] - cuts.at[k]);
    if (!(pin.side * distance_at(middle) > 0.0)) {
      continue;
    }
    for (const auto& point : shape::line_rule(pressure_degree)) {
      const double r = middle + half * point.r[0];
      const Vec2 arm = arm_at(r);
      const Vec2 tangent = pin.axes.transpose() * edge.tangents({r, 0.0}).col(0);
      const double distance = arm.norm();
      // Length of the exact arc: R dtheta.
      const double turn = std::abs(arm.x() * tangent.y() - arm.y() * tangent.x());
      const double ds = pin.circle.radius * turn / (distance * distance) * half;
      visit(Vec2(r, 0.0), Vec2((pin.side / distance) * arm), point.weight * thickness * ds);
    }
  }
}

template <class Visit>
void for_points_on_face(const Pin& pin, const ElementSide& face, Visit&& visit) {
  face.for_quadrature_points(pressure_degree, [&](const Vec2& r, double weight) {
    const Vec2 radial = pin.arm(face.position(r)).normalized();
    // Against the outer normal: away from the centre of a bore, towards that of a shaft.
    const double outward = radial.dot(pin.axes.transpose() * face.area_vector(r));
    visit(r, Vec2((outward < 0.0 ? 1.0 : -1.0) * radial), weight * std::abs(outward));
  });
}

// Calls visit(r, main, across) at the points of the loaded half of a face: the forces of the two
// unit pressures p = cos(theta) or 1, and p = sin(theta).
template <class Visit>
void for_unit_pressures(const model::Model& model, const model::Mesh& mesh, const Pin& pin,
                        const model::Face& face, Visit&& visit) {
  const ElementSide side = model::element_side(mesh, face);
  const auto press = [&](const Vec2& r, const Vec2& push, double area) {
    const double cosine = push.dot(pin.d);
    if (cosine > 0.0) {
      const Vec2 force = area * push;
      visit(r, Vec2((pin.cosine ? cosine : 1.0) * force), Vec2(push.dot(pin.across()) * force));
    }
  };
  if (side.is_edge()) {
    for_points_on_edge(pin, side, model.element_property(mesh, face.element).thickness, press);
  } else {
    for_points_on_face(pin, side, press);
  }
}

// In the plane: the circle through the nodes.
std::optional<Pin> pin_on_edges(const model::Mesh& mesh, const std::vector<model::Face>& faces,
                                const Vec3& F) {
  Pin pin;
  pin.axes.setIdentity();
  // Nodes shared by two edges count twice, which does no harm to nodes on a circle.
  std::vector<geometry::WeightedPoint> points;
  for (const model::Face& face : faces) {
    for (const base::NodeId n : model::side_nodes(mesh, face)) {
      points.push_back({mesh.x[n.index()].head<2>(), 1.0});
    }
  }
  pin.circle = geometry::fit_circle(points);
  double inward = 0.0; // outer normals of a bore point to its centre
  for (const model::Face& face : faces) {
    const ElementSide edge = model::element_side(mesh, face);
    inward -= edge.area_vector(Vec2::Zero()).head<2>().dot(pin.arm(edge.position(Vec2::Zero())));
  }
  pin.side = inward > 0.0 ? 1.0 : -1.0;
  pin.force = F.head<2>();
  return pin;
}

// Calls f(x, a) with each integration point of the faces and its outward area vector.
template <class F>
void for_area_vectors(const model::Mesh& mesh, const std::vector<model::Face>& faces, F&& f) {
  for (const model::Face& face : faces) {
    const ElementSide side = model::element_side(mesh, face);
    side.for_quadrature_points(load_degree, [&](const Vec2& r, double weight) {
      f(side.position(r), Vec3(weight * side.area_vector(r)));
    });
  }
}

// In space: across the direction that no normal has a part in, the first axis along the load;
// empty when that has a part along the axis.
std::optional<Pin> pin_on_faces(const model::Mesh& mesh, const std::vector<model::Face>& faces,
                                const Vec3& F) {
  Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
  for_area_vectors(mesh, faces, [&](const Vec3& /*x*/, const Vec3& a) {
    normals += a * a.transpose() / std::max(a.norm(), 1e-300);
  });
  const Vec3 axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(normals).eigenvectors().col(0);
  if (std::abs(axis.dot(F)) > 1e-6 * F.norm()) {
    return std::nullopt; // a pin pushes across its axis
  }
  Pin pin;
  pin.axes << F.normalized(), axis.cross(F.normalized());
  std::vector<geometry::WeightedPoint> points;
  for_area_vectors(mesh, faces, [&](const Vec3& x, const Vec3& a) {
    points.push_back({pin.axes.transpose() * x, a.norm()});
  });
  pin.circle = geometry::fit_circle(points);
  pin.force = {F.norm(), 0.0};
  return pin;
}

constexpr base::ByDimension pins{&pin_on_edges, &pin_on_faces};

// Whether a plane of symmetry that cuts the faces runs along the load and the axis; one across the
// axis does nothing.
bool is_balanced(const std::array<bool, 3>& cuts, const Vec3& across) {
  bool balanced = false;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    balanced = balanced || (cuts.at(i) && std::abs(across[static_cast<Eigen::Index>(i)]) > 0.5);
  }
  return balanced;
}

} // namespace

std::array<bool, 3> mirror_cut_axes(const model::Model& model, const model::Mesh& mesh,
                                    const model::Load& load) {
  constexpr double in_plane = 1e-6; // of the faces' extent
  std::vector<base::NodeId> nodes;
  for (const model::Face& face : mesh.set_with_id(load.faces).faces) {
    std::ranges::copy(model::side_nodes(mesh, face), std::back_inserter(nodes));
  }
  std::array<bool, 3> cuts{};
  for (const model::MirrorPlane& plane : model.mirrors) {
    double nearest = std::numeric_limits<double>::infinity();
    double farthest = 0.0;
    for (const base::NodeId n : nodes) {
      const double off = std::abs(mesh.x[n.index()][plane.axis] - plane.at.value_or(0.0));
      nearest = std::min(nearest, off);
      farthest = std::max(farthest, off);
    }
    const auto axis = static_cast<std::size_t>(plane.axis);
    cuts.at(axis) =
        plane.at && nearest <= in_plane * farthest && load.value[axis](Vec3::Zero()) == 0.0;
  }
  return cuts;
}

bool for_bearing_points(const model::Model& model, const model::Mesh& mesh, const model::Load& load,
                        const LoadPointVisitor::FaceVisit& visit) {
  const std::vector<model::Face>& faces = mesh.set_with_id(load.faces).faces;
  const Vec3 F = load_value(load, Vec3::Zero());
  if (F.isZero(0.0)) {
    return true;
  }
  std::optional<Pin> pin = pins.at(mesh.dim)(mesh, faces, F);
  if (!pin) {
    return false;
  }
  pin->d = pin->force.normalized();
  pin->cosine = load.shape == model::BearingShape::cosine;
  Eigen::Matrix2d total = Eigen::Matrix2d::Zero(); // column 0: sum of main, 1: of across
  for (const model::Face& face : faces) {
    for_unit_pressures(model, mesh, *pin, face,
                       [&](const Vec2& /*r*/, const Vec2& main, const Vec2& across) {
                         total.col(0) += main;
                         total.col(1) += across;
                       });
  }
  // p0 and p1 of (fe.19). Singular where no face lies in the loaded half.
  const Eigen::FullPivLU<Eigen::Matrix2d> lu(total);
  if (!lu.isInvertible()) {
    return false;
  }
  const bool balanced = is_balanced(mirror_cut_axes(model, mesh, load), pin->axes * pin->across());
  const Vec2 p = balanced ? Vec2(pin->force.norm() / total.col(0).dot(pin->d), 0.0)
                          : Vec2(lu.solve(pin->force));
  std::vector<LoadPoint> points;
  for (const model::Face& face : faces) {
    points.clear();
    for_unit_pressures(
        model, mesh, *pin, face, [&](const Vec2& r, const Vec2& main, const Vec2& across) {
          points.push_back({base::embed_in_space(r), pin->axes * (p[0] * main + p[1] * across)});
        });
    visit(face, points);
  }
  return true;
}

} // namespace spricka::fe
