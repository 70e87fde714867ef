// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/quality.hpp"

#include "shape/quadrature.hpp"
#include "shape/solid.hpp"
#include "shape/topology.hpp"

#include <Eigen/LU>

#include <cmath>

namespace spricka::mesh {
namespace {

/// Zero for our purpose, as a part of the largest determinant of the element.
constexpr double zero = 1e-10;

/// Derivatives of the shape functions at the points where the determinant is taken.
template <shape::ElementShape S> struct Samples {
  std::vector<Eigen::Matrix<double, S::nodes, S::dim>> dN;
  std::vector<shape::Point<S::dim>> at;
  std::size_t inner = 0; ///< the first ones are the integration points

  Samples() {
    for (const auto& q : shape::quadrature<S>()) {
      add(q.r);
    }
    inner = at.size();
    for (int i = 0; i < S::nodes; ++i) {
      add(shape::node<S>(i));
    }
    if (S::dim == 3 && base::info(S::type).quadratic) {
      add_between_nodes();
    }
  }

private:
  void add(const shape::Point<S::dim>& r) {
    at.push_back(r);
    dN.push_back(S::dN(r));
  }
  /// Quarter points of edges and centres of sides: where a curved solid turns over first.
  void add_between_nodes() {
    for (int m = 0; m < shape::edge_count(S::type); ++m) {
      const auto [a, b] = shape::edge_corners(S::type, m);
      add(0.75 * shape::node<S>(a) + 0.25 * shape::node<S>(b));
      add(0.25 * shape::node<S>(a) + 0.75 * shape::node<S>(b));
    }
    for (int s = 0; s < base::info(S::type).sides; ++s) {
      const auto corners = static_cast<int>(shape::side_corners(S::type, s));
      shape::Point<S::dim> middle = shape::Point<S::dim>::Zero();
      for (const int i : shape::side_nodes(S::type, s).first(static_cast<std::size_t>(corners))) {
        middle += shape::node<S>(i) / corners;
      }
      add(middle);
    }
  }
};

template <shape::ElementShape S> const Samples<S>& samples() {
  static const Samples<S> all;
  return all;
}

/// Mid-edge nodes of a tetrahedron halfway: its Jacobian is constant then.
template <shape::ElementShape S>
bool is_straight(const Eigen::Matrix<double, S::nodes, S::dim>& X) {
  if constexpr (S::domain != shape::Domain::tetrahedron || S::nodes == 4) {
    return S::nodes == S::dim + 1;
  } else {
    for (int m = 0; m < shape::edge_count(S::type); ++m) {
      const auto [a, b] = shape::edge_corners(S::type, m);
      const double off = (2.0 * X.row(4 + m) - X.row(a) - X.row(b)).squaredNorm();
      if (!(off <= 1e-24 * (X.row(a) - X.row(b)).squaredNorm())) {
        return false;
      }
    }
    return true;
  }
}

template <shape::ElementShape S>
bool check(std::span<const base::NodeId> nodes, const std::vector<base::Vec3>& x,
           BadElement& worst) {
  using Coordinates = Eigen::Matrix<double, S::nodes, S::dim>;
  Coordinates X;
  for (int i = 0; i < S::nodes; ++i) {
    X.row(i) = x[nodes[static_cast<std::size_t>(i)].index()].template head<S::dim>().transpose();
  }
  const Samples<S>& sample = samples<S>();
  double largest = 0.0;
  bool first = true;
  const auto meet = [&](std::size_t k) {
    const Eigen::Matrix<double, S::dim, S::dim> J = sample.dN[k].transpose() * X;
    const double det = J.determinant();
    largest = std::max(largest, std::abs(det));
    worst.turned = (first || worst.turned) && det < 0.0;
    if (first || det < worst.jacobian) {
      first = false;
      worst.jacobian = det;
      worst.at.setZero();
      worst.at.template head<S::dim>() = (S::N(sample.at[k]).transpose() * X).transpose();
    }
  };
  if (is_straight<S>(X)) {
    meet(0);
    // a flat element has a determinant of zero, measured by its longest side
    const double size = (X.rowwise() - X.row(0)).cwiseAbs().maxCoeff();
    return worst.jacobian > zero * std::pow(size, S::dim);
  }
  for (std::size_t k = 0; k < sample.inner; ++k) {
    meet(k);
  }
  if (!(worst.jacobian > zero * largest)) { // also catches NaN
    return false;
  }
  for (std::size_t k = sample.inner; k < sample.at.size(); ++k) {
    meet(k);
  }
  return worst.jacobian > -zero * largest;
}

} // namespace

std::vector<BadElement> bad_elements(const model::Mesh& mesh) {
  std::vector<BadElement> result;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
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
