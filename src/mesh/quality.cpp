// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/quality.hpp"

#include "shape/quadrature.hpp"
#include "shape/shape.hpp"

#include <Eigen/LU>

namespace spricka::mesh {
namespace {

/// Zero for our purpose, as a part of the largest determinant of the element.
constexpr double zero = 1e-10;

template <shape::ElementShape S>
bool check(std::span<const base::NodeId> nodes, const std::vector<base::Vec3>& x,
           BadElement& worst) {
  Eigen::Matrix<double, S::nodes, 2> X;
  for (int i = 0; i < S::nodes; ++i) {
    X.row(i) = x[nodes[static_cast<std::size_t>(i)].index()].template head<2>().transpose();
  }
  const auto determinant = [&](const shape::Point<2>& r) {
    const Eigen::Matrix2d J = S::dN(r).transpose() * X;
    return J.determinant();
  };
  double largest = 0.0;
  bool first = true;
  const auto meet = [&](const shape::Point<2>& r) {
    const double det = determinant(r);
    largest = std::max(largest, std::abs(det));
    if (first || det < worst.jacobian) {
      first = false;
      worst.jacobian = det;
      worst.at.setZero();
      worst.at.template head<2>() = (S::N(r).transpose() * X).transpose();
    }
  };
  for (const shape::QuadraturePoint<2>& q : shape::quadrature<S>()) {
    meet(q.r);
  }
  if (!(worst.jacobian > zero * largest)) { // also catches NaN
    return false;
  }
  for (int i = 0; i < S::nodes; ++i) {
    meet(shape::node<S>(i));
  }
  return worst.jacobian > -zero * largest;
}

} // namespace

std::vector<BadElement> bad_elements(const model::Mesh& mesh) {
  std::vector<BadElement> result;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    if (base::info(mesh.type[e]).dim != 2) {
      continue;
    }
    BadElement worst{base::ElementId(e)};
    const bool good = shape::with_shape(mesh.type[e], [&]<shape::ElementShape S>(S) {
      return check<S>(mesh.nodes_of(base::ElementId(e)), mesh.x, worst);
    });
    if (!good) {
      result.push_back(worst);
    }
  }
  return result;
}

} // namespace spricka::mesh
