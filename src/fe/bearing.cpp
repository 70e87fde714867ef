// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/bearing.hpp"

#include "fe/circle_fit.hpp"
#include "model/mesh_side.hpp"
#include "model/model.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace spricka::fe {

namespace {

using base::Vec2;
using base::Vec3;
using base::Vector;

constexpr int pressure_degree = 15;

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

// What every edge needs to know.
struct Pin {
  Bore bore;
  Vec2 d = Vec2::Zero(); ///< unit vector along the load
  model::BearingShape shape = model::BearingShape::cosine;
};

Vec2 place_on(const geometry::ElementSide& edge, double r) {
  return edge.position({r, 0.0}).head<2>();
}

// Calls visit(t, main, across) at points of a piece of an edge: the forces of the two unit
// pressures p = cos(theta) or 1, and p = sin(theta).
template <class Visit>
void for_piece(const Pin& pin, const geometry::ElementSide& edge, double from, double to,
               double thickness, Visit&& visit) {
  const Vec2 across(-pin.d.y(), pin.d.x());
  for (const auto& point : shape::line_rule(pressure_degree)) {
    const double r = 0.5 * (from + to) + 0.5 * (to - from) * point.r[0];
    const Vec2 arm = place_on(edge, r) - pin.bore.centre;
    const Vec2 tangent = edge.tangents({r, 0.0}).col(0).head<2>();
    const double distance = arm.norm();
    const Vec2 m = (pin.bore.side / distance) * arm; // the way the pressure pushes
    // Length of the exact arc: R dtheta.
    const double turn = std::abs(arm.x() * tangent.y() - arm.y() * tangent.x());
    const double ds = pin.bore.radius * turn / (distance * distance) * 0.5 * (to - from);
    const double cosine = m.dot(pin.d);
    if (cosine <= 0.0) {
      continue;
    }
    const double p = pin.shape == model::BearingShape::cosine ? cosine : 1.0;
    const Vec2 force = point.weight * thickness * ds * m;
    visit(r, Vec2(p * force), Vec2(m.dot(across) * force));
  }
}

template <class Visit>
void for_edge(const Pin& pin, const geometry::ElementSide& edge, double thickness, Visit&& visit) {
  // Along the load from the centre: its zeros are where |theta| = 90 degrees.
  const auto distance = [&](double r) { return (place_on(edge, r) - pin.bore.centre).dot(pin.d); };
  const Cuts cuts = cut_edge(distance(-1.0), distance(0.0), distance(1.0));
  for (std::size_t k = 0; k + 1 < cuts.count; ++k) {
    if (pin.bore.side * distance(0.5 * (cuts.at[k] + cuts.at[k + 1])) > 0.0) {
      for_piece(pin, edge, cuts.at[k], cuts.at[k + 1], thickness, visit);
    }
  }
}

} // namespace

Bore fit_bore(const model::Mesh& mesh, const std::vector<model::Face>& faces) {
  // Nodes shared by two edges count twice, which does no harm to nodes on a circle.
  std::vector<WeightedPoint> points;
  for (const model::Face& face : faces) {
    for (const base::NodeId n : model::side_nodes(mesh, face)) {
      points.push_back({mesh.x[n.index()].head<2>(), 1.0});
    }
  }
  const FittedCircle circle = fit_circle(points);
  Bore bore;
  bore.centre = circle.centre;
  bore.radius = circle.radius;

  double inward = 0.0; // outer normals of a bore point to its centre
  for (const model::Face& face : faces) {
    const geometry::ElementSide edge = model::element_side(mesh, face);
    const Vec3 normal = edge.area_vector(Vec2::Zero());
    inward += normal.head<2>().dot(bore.centre - place_on(edge, 0.0));
  }
  bore.side = inward > 0.0 ? 1.0 : -1.0;
  return bore;
}

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
                        const BearingVisit& visit) {
  assert(mesh.dim == 2);
  assert(load.value.size() >= 2);
  const std::vector<model::Face>& faces = mesh.set_with_id(load.faces).faces;
  const Vec2 F(load.value[0](Vec3::Zero()), load.value[1](Vec3::Zero()));
  if (F.isZero(0.0)) {
    return true;
  }
  const Pin pin{fit_bore(mesh, faces), F.normalized(), load.shape};
  const auto for_points = [&](auto&& point) {
    for (const model::Face& face : faces) {
      for_edge(
          pin, model::element_side(mesh, face),
          model.element_property(mesh, face.element).thickness,
          [&](double t, const Vec2& main, const Vec2& across) { point(face, t, main, across); });
    }
  };
  Eigen::Matrix2d total = Eigen::Matrix2d::Zero(); // column 0: sum of main, 1: of across
  for_points([&](const model::Face& /*face*/, double /*t*/, const Vec2& main, const Vec2& across) {
    total.col(0) += main;
    total.col(1) += across;
  });
  // p0 and p1 of (fe.19). Singular where no face lies in the loaded half.
  const Eigen::FullPivLU<Eigen::Matrix2d> lu(total);
  if (!lu.isInvertible()) {
    return false;
  }
  const std::array<bool, 3> cuts = mirror_cut_axes(model, mesh, load);
  const bool balanced = cuts[0] || cuts[1] || cuts[2];
  const Vec2 p = balanced ? Vec2(F.norm() / total.col(0).dot(pin.d), 0.0) : Vec2(lu.solve(F));
  for_points([&](const model::Face& face, double t, const Vec2& main, const Vec2& across) {
    visit(face, t, p[0] * main + p[1] * across);
  });
  return true;
}

bool add_bearing(const model::Model& model, const model::Mesh& mesh, const model::Load& load,
                 Vector& f) {
  return for_bearing_points(
      model, mesh, load, [&](const model::Face& face, double t, const Vec2& force) {
        const geometry::ElementSide side = model::element_side(mesh, face);
        const geometry::SideValues N = side.N({t, 0.0});
        for (std::size_t i = 0; i < side.nodes.size(); ++i) {
          f.segment<2>(2 * static_cast<Eigen::Index>(side.nodes[i].index())) +=
              N[static_cast<Eigen::Index>(i)] * force;
        }
      });
}

} // namespace spricka::fe
