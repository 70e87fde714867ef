// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/quality.hpp"

#include "shape/quadrature.hpp"
#include "shape/solid.hpp"
#include "shape/topology.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace spricka::mesh {
namespace {

/// Zero for our purpose, as a part of the largest determinant of the element.
constexpr double zero = 1e-10;

/// How far below zero the determinant of a solid may lie at a node, as a part of its mean. The
/// solid patch of MacNeal and Harder (1985) has a corner of -8 %.
constexpr double slight = 0.1;
/// Body forces are integrated by this degree, closer to the corners than the stiffness.
constexpr int finest_degree = 9;

/// Derivatives of the shape functions at the points where the determinant is taken.
template <shape::ElementShape S> struct Samples {
  std::vector<Eigen::Matrix<double, S::nodes, S::dim>> dN;
  std::vector<shape::Point<S::dim>> at;
  std::vector<double> weight; ///< of the integration points, in sum 1
  std::size_t inner = 0;      ///< the first ones are the integration points
  std::size_t outer = 0;      ///< behind them the nodes, then points between nodes

  Samples() {
    double sum = 0.0;
    for (const auto& q : shape::quadrature<S>()) {
      add(q.r);
      weight.push_back(q.weight);
      sum += q.weight;
    }
    for (double& w : weight) {
      w /= sum;
    }
    inner = at.size();
    for (int i = 0; i < S::nodes; ++i) {
      add(shape::node<S>(i));
    }
    outer = at.size();
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

template <shape::ElementShape S> using Coordinates = Eigen::Matrix<double, S::nodes, S::dim>;

template <shape::ElementShape S>
double determinant(const Coordinates<S>& X, const Eigen::Matrix<double, S::nodes, S::dim>& dN) {
  return Eigen::Matrix<double, S::dim, S::dim>(dN.transpose() * X).determinant();
}

/// Whether the determinant is positive at the integration points of the finest rule.
template <shape::ElementShape S> bool sound_inside(const Coordinates<S>& X, double least) {
  const auto rule = shape::quadrature<S>(finest_degree);
  return std::all_of(rule.begin(), rule.end(),
                     [&](const auto& q) { return determinant<S>(X, S::dN(q.r)) > least; });
}

/// What is wrong with one element.
enum class Fault { none, corner, bad };

template <shape::ElementShape S>
Fault check(std::span<const base::NodeId> nodes, const std::vector<base::Vec3>& x,
            BadElement& worst, FoldedCorner& corner) {
  Coordinates<S> X;
  for (int i = 0; i < S::nodes; ++i) {
    X.row(i) = x[nodes[static_cast<std::size_t>(i)].index()].template head<S::dim>().transpose();
  }
  const Samples<S>& sample = samples<S>();
  double largest = 0.0;
  double mean = 0.0;
  bool first = true;
  const auto meet = [&](std::size_t k) {
    const double det = determinant<S>(X, sample.dN[k]);
    largest = std::max(largest, std::abs(det));
    worst.turned = (first || worst.turned) && det < 0.0;
    if (first || det < worst.jacobian) {
      first = false;
      worst.jacobian = det;
      worst.at.setZero();
      worst.at.template head<S::dim>() = (S::N(sample.at[k]).transpose() * X).transpose();
    }
    return det;
  };
  if (is_straight<S>(X)) {
    meet(0);
    // a flat element has a determinant of zero, measured by its longest side
    const double size = (X.rowwise() - X.row(0)).cwiseAbs().maxCoeff();
    return worst.jacobian > zero * std::pow(size, S::dim) ? Fault::none : Fault::bad;
  }
  for (std::size_t k = 0; k < sample.inner; ++k) {
    mean += sample.weight[k] * meet(k);
  }
  if (!(worst.jacobian > zero * largest)) { // also catches NaN
    return Fault::bad;
  }
  for (std::size_t k = sample.inner; k < sample.outer; ++k) {
    if (const double det = meet(k); det < corner.part) {
      corner.part = det;
      corner.node = nodes[k - sample.inner];
    }
  }
  corner.part /= mean;
  bool between = true;
  for (std::size_t k = sample.outer; k < sample.at.size(); ++k) {
    between = meet(k) > -zero * largest && between;
  }
  if (worst.jacobian > -zero * largest) {
    return Fault::none;
  }
  const bool tolerable =
      S::dim == 3 && between && corner.part >= -slight && sound_inside<S>(X, zero * largest);
  return tolerable ? Fault::corner : Fault::bad;
}

} // namespace

MeshFaults mesh_faults(const model::Mesh& mesh) {
  MeshFaults faults;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    BadElement worst{base::ElementId(e)};
    FoldedCorner corner{base::ElementId(e), {}, 0.0};
    const Fault fault = shape::with_shape(mesh.type[e], [&]<shape::ElementShape S>(S) {
      return check<S>(mesh.nodes_of(base::ElementId(e)), mesh.x, worst, corner);
    });
    if (fault == Fault::bad) {
      faults.bad.push_back(worst);
    } else if (fault == Fault::corner) {
      faults.corners.push_back(corner);
    }
  }
  return faults;
}

std::vector<BadElement> bad_elements(const model::Mesh& mesh) {
  return mesh_faults(mesh).bad;
}

} // namespace spricka::mesh
