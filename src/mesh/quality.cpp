// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/quality.hpp"

#include "base/by_dimension.hpp"
#include "base/with_dimension.hpp"
#include "shape/quadrature.hpp"
#include "shape/reference_element.hpp"
#include "shape/topology.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace spricka::mesh {
namespace {

/// Zero for our purpose, as a part of the largest determinant of the element.
constexpr double zero = 1e-10;

/// How far below zero the determinant may lie at a node, as a part of its mean. The solid patch of
/// MacNeal and Harder (1985) has a corner of -8 %.
constexpr base::ByDimension slight{0.0, 0.1};
/// Body forces are integrated by this degree, closer to the corners than the stiffness.
constexpr int finest_degree = 9;

template <int dim> using Element = shape::ReferenceElement<dim>;
/// Of the nodes of an element. [node, dim]
template <int dim> using Coordinates = typename Element<dim>::ShapeDerivatives;

/// Derivatives of the shape functions at the points where the determinant is taken.
template <int dim> struct Samples {
  const Element<dim>* element = nullptr;
  std::vector<typename Element<dim>::ShapeDerivatives> dN;
  std::vector<shape::Point<dim>> at;
  std::vector<double> weight; ///< of the integration points, in sum 1
  std::size_t inner = 0;      ///< the first ones are the integration points
  std::size_t outer = 0;      ///< behind them the nodes, then points between nodes

  explicit Samples(base::ElementType type) : element(&shape::reference_element<dim>(type)) {
    double sum = 0.0;
    for (const auto& q : shape::quadrature<dim>(element->domain, element->degree)) {
      add(q.r);
      weight.push_back(q.weight);
      sum += q.weight;
    }
    for (double& w : weight) {
      w /= sum;
    }
    inner = at.size();
    for (int i = 0; i < element->nodes; ++i) {
      add(element->node_local_coordinates(i));
    }
    outer = at.size();
    if (slight.at(dim) > 0.0 && element->quadratic) {
      add_between_nodes(type);
    }
  }

  /// Of a type of this dimension; made once, for all of them.
  static const Samples& of(base::ElementType type) {
    static const std::vector<std::optional<Samples>> all = [] {
      std::vector<std::optional<Samples>> made(base::element_infos.size());
      for (std::size_t t = 0; t < made.size(); ++t) {
        if (base::element_infos[t].dim == dim) {
          made[t].emplace(static_cast<base::ElementType>(t));
        }
      }
      return made;
    }();
    return *all[static_cast<std::size_t>(type)];
  }

private:
  void add(const shape::Point<dim>& r) {
    at.push_back(r);
    dN.push_back(element->dN(r));
  }
  /// Quarter points of edges and centres of sides: where a curved solid turns over first.
  void add_between_nodes(base::ElementType type) {
    for (int m = 0; m < shape::edge_count(type); ++m) {
      const auto [a, b] = shape::edge_corners(type, m);
      add(0.75 * element->node_local_coordinates(a) + 0.25 * element->node_local_coordinates(b));
      add(0.25 * element->node_local_coordinates(a) + 0.75 * element->node_local_coordinates(b));
    }
    for (int s = 0; s < base::element_info(type).sides; ++s) {
      const auto corners = static_cast<int>(shape::side_corner_count(type, s));
      shape::Point<dim> middle = shape::Point<dim>::Zero();
      for (const int i : shape::side_nodes(type, s).first(static_cast<std::size_t>(corners))) {
        middle += element->node_local_coordinates(i) / corners;
      }
      add(middle);
    }
  }
};

/// Mid-edge nodes of a tetrahedron halfway: its Jacobian is constant then.
template <int dim> bool is_straight(base::ElementType type, const Coordinates<dim>& X) {
  if (type != base::ElementType::tet10) {
    return X.rows() == dim + 1;
  }
  for (int m = 0; m < shape::edge_count(type); ++m) {
    const auto [a, b] = shape::edge_corners(type, m);
    const double off = (2.0 * X.row(4 + m) - X.row(a) - X.row(b)).squaredNorm();
    if (!(off <= 1e-24 * (X.row(a) - X.row(b)).squaredNorm())) {
      return false;
    }
  }
  return true;
}

template <int dim>
double determinant(const Coordinates<dim>& X, const typename Element<dim>::ShapeDerivatives& dN) {
  return Eigen::Matrix<double, dim, dim>(dN.transpose().lazyProduct(X)).determinant();
}

/// Whether a curved tetrahedron is so near its straight one that its determinant has one sign
/// wherever it is taken. With d_m what the node of edge m = ab is off the middle, L the barycentric
/// coordinates and g their gradients, the map of the straight one to the curved has the gradient
/// I + sum d_m (4 L_a g_b + 4 L_b g_a)^T; its determinant is positive where that sum is below 1,
/// and the largest sum of norms stands at a corner, as L are linear.
bool is_nearly_straight(base::ElementType type, const Coordinates<3>& X) {
  if (type != base::ElementType::tet10) {
    return false;
  }
  const base::Vec3 first = X.row(0);
  const std::array<base::Vec3, 3> side{X.row(1).transpose() - first, X.row(2).transpose() - first,
                                       X.row(3).transpose() - first};
  std::array<base::Vec3, 4> area{base::Vec3::Zero(), side[1].cross(side[2]), side[2].cross(side[0]),
                                 side[0].cross(side[1])}; // gradients times the determinant
  area[0] = -(area[1] + area[2] + area[3]);
  const double det = side[0].dot(area[1]);
  double size = 0.0;
  for (const base::Vec3& s : side) {
    size = std::max(size, s.cwiseAbs().maxCoeff());
  }
  constexpr double clearly = 10.0;
  if (!(det > clearly * zero * size * size * size)) {
    return false;
  }
  std::array<double, 4> gradient{};
  for (std::size_t i = 0; i < 4; ++i) {
    gradient.at(i) = area.at(i).norm() / det;
  }
  std::array<double, 4> change{};
  for (int m = 0; m < shape::edge_count(type); ++m) {
    const auto [a, b] = shape::edge_corners(type, m);
    const auto i = static_cast<std::size_t>(a);
    const auto j = static_cast<std::size_t>(b);
    const double off = (X.row(4 + m) - 0.5 * (X.row(a) + X.row(b))).norm();
    change.at(i) += 4.0 * off * gradient.at(j);
    change.at(j) += 4.0 * off * gradient.at(i);
  }
  constexpr double most = 0.9; // determinants within 0.1^3 and 1.9^3 of that of the straight one
  return *std::ranges::max_element(change) < most;
}

/// In the plane elements are few enough to be looked at in full.
bool is_nearly_straight(base::ElementType /*type*/, const Coordinates<2>& /*X*/) {
  return false;
}

/// Whether the determinant is positive at the integration points of the finest rule.
template <int dim>
bool sound_inside(const Element<dim>& element, const Coordinates<dim>& X, double least) {
  const auto rule = shape::quadrature<dim>(element.domain, finest_degree);
  return std::all_of(rule.begin(), rule.end(),
                     [&](const auto& q) { return determinant<dim>(X, element.dN(q.r)) > least; });
}

/// What is wrong with one element.
enum class Fault { none, corner, bad };

template <int dim>
Fault check(base::ElementType type, std::span<const base::NodeId> nodes,
            const std::vector<base::Vec3>& x, InvalidElement& worst, FoldedCorner& corner) {
  const Samples<dim>& sample = Samples<dim>::of(type);
  const Element<dim>& element = *sample.element;
  Coordinates<dim> X(element.nodes, dim);
  for (int i = 0; i < element.nodes; ++i) {
    X.row(i) = x[nodes[static_cast<std::size_t>(i)].index()].template head<dim>().transpose();
  }
  if (is_nearly_straight(type, X)) {
    return Fault::none;
  }
  double largest = 0.0;
  double mean = 0.0;
  bool first = true;
  const auto meet = [&](std::size_t k) {
    const double det = determinant<dim>(X, sample.dN[k]);
    largest = std::max(largest, std::abs(det));
    worst.turned = (first || worst.turned) && det < 0.0;
    if (first || det < worst.jacobian) {
      first = false;
      worst.jacobian = det;
      worst.at.setZero();
      worst.at.template head<dim>() = X.transpose() * element.N(sample.at[k]);
    }
    return det;
  };
  if (is_straight<dim>(type, X)) {
    meet(0);
    // a flat element has a determinant of zero, measured by its longest side
    const double size = (X.rowwise() - X.row(0)).cwiseAbs().maxCoeff();
    return worst.jacobian > zero * std::pow(size, dim) ? Fault::none : Fault::bad;
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
      between && corner.part >= -slight.at(dim) && sound_inside<dim>(element, X, zero * largest);
  return tolerable ? Fault::corner : Fault::bad;
}

} // namespace

MeshFaults find_mesh_faults(const model::Mesh& mesh) {
  MeshFaults faults;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    InvalidElement worst{base::ElementId(e)};
    FoldedCorner corner{base::ElementId(e), {}, 0.0};
    const base::ElementType type = mesh.type[e];
    const std::span<const base::NodeId> nodes = mesh.element_nodes(base::ElementId(e));
    const Fault fault = base::with_dimension(base::element_info(type).dim, [&](auto dim) {
      return check<dim>(type, nodes, mesh.x, worst, corner);
    });
    if (fault == Fault::bad) {
      faults.bad.push_back(worst);
    } else if (fault == Fault::corner) {
      faults.corners.push_back(corner);
    }
  }
  return faults;
}

std::vector<InvalidElement> find_invalid_elements(const model::Mesh& mesh) {
  return find_mesh_faults(mesh).bad;
}

} // namespace spricka::mesh
