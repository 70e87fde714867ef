// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/measure_quality.hpp"

#include "shape/quadrature.hpp"
#include "shape/reference_element.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/LU>

namespace spricka::mesh {

namespace {

struct Measures {
  double scaled_jacobian = 1.0;
  double aspect = 1.0;
  double smallest_angle = std::numbers::pi;
  double largest_angle = 0.0;
  base::Vec3 centroid = base::Vec3::Zero();
};

double scaled_jacobian(const shape::ReferenceElement<2>& element,
                       std::span<const base::NodeId> nodes, const std::vector<base::Vec3>& x) {
  shape::ReferenceElement<2>::ShapeDerivatives X(element.nodes, 2); // [node, dim]
  for (int i = 0; i < element.nodes; ++i) {
    X.row(i) = x[nodes[static_cast<std::size_t>(i)].index()].head<2>().transpose();
  }
  // The columns of an equilateral triangle's Jacobian meet at 60 degrees.
  const double ideal = element.corners == 3 ? 0.5 * std::numbers::sqrt3 : 1.0;
  double smallest = 1.0;
  for (const shape::QuadraturePoint<2>& q : shape::quadrature<2>(element.domain, element.degree)) {
    const Eigen::Matrix2d J = element.dN(q.r).transpose().lazyProduct(X);
    const double lengths = J.row(0).norm() * J.row(1).norm();
    smallest = std::min(smallest, lengths > 0.0 ? J.determinant() / (ideal * lengths) : 0.0);
  }
  return smallest;
}

Measures measure(const model::Mesh& mesh, base::ElementId e) {
  const std::span<const base::NodeId> nodes = mesh.element_nodes(e);
  const auto corners = static_cast<std::size_t>(base::element_info(mesh.type[e.index()]).corners);
  Measures m;
  m.centroid = model::element_corner_mean(mesh, e);
  double longest = 0.0;
  double shortest = 0.0;
  for (std::size_t i = 0; i < corners; ++i) {
    const base::Vec3& at = mesh.x[nodes[i].index()];
    const base::Vec3 next = mesh.x[nodes[(i + 1) % corners].index()] - at;
    const base::Vec3 last = mesh.x[nodes[(i + corners - 1) % corners].index()] - at;
    longest = std::max(longest, next.norm());
    shortest = i == 0 ? next.norm() : std::min(shortest, next.norm());
    const double lengths = next.norm() * last.norm();
    const double angle =
        lengths > 0.0 ? std::acos(std::clamp(next.dot(last) / lengths, -1.0, 1.0)) : 0.0;
    m.smallest_angle = std::min(m.smallest_angle, angle);
    m.largest_angle = std::max(m.largest_angle, angle);
  }
  m.aspect = shortest > 0.0 ? longest / shortest : std::numeric_limits<double>::infinity();
  m.scaled_jacobian =
      scaled_jacobian(shape::reference_element<2>(mesh.type[e.index()]), nodes, mesh.x);
  return m;
}

} // namespace

std::optional<MeshQuality> measure_quality(const model::Mesh& mesh,
                                           std::span<const base::ElementId> elements) {
  std::optional<MeshQuality> worst;
  for (const base::ElementId e : elements) {
    if (base::element_info(mesh.type[e.index()]).dim != 2) {
      continue;
    }
    const Measures m = measure(mesh, e);
    const bool first = !worst;
    if (first) {
      worst.emplace();
    }
    const auto meet = [&](WorstElement& w, double value, bool worse) {
      if (first || worse) {
        w = {e, value, m.centroid};
      }
    };
    meet(worst->scaled_jacobian, m.scaled_jacobian,
         m.scaled_jacobian < worst->scaled_jacobian.value);
    meet(worst->aspect, m.aspect, m.aspect > worst->aspect.value);
    meet(worst->smallest_angle, m.smallest_angle, m.smallest_angle < worst->smallest_angle.value);
    meet(worst->largest_angle, m.largest_angle, m.largest_angle > worst->largest_angle.value);
  }
  return worst;
}

} // namespace spricka::mesh
