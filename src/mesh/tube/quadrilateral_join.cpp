// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/quadrilateral_join.hpp"

#include "shape/quadrature.hpp"
#include "shape/reference_element.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <array>
#include <cassert>
#include <cstddef>
#include <numeric>
#include <vector>

namespace spricka::mesh {
namespace {

using base::Matrix;
using base::Vec2;
using base::Vec3;

constexpr std::size_t middle = 8; ///< the node there, whether of the quadrilateral or not

/// Nodes of a quadrilateral along its mean plane, over its size, from its middle.
std::vector<Vec2> flatten(std::span<const Vec3> nodes) {
  const Vec3 first = nodes[2] - nodes[0];
  const Vec3 second = nodes[3] - nodes[1];
  const Vec3 centre = 0.25 * (nodes[0] + nodes[1] + nodes[2] + nodes[3]);
  const Vec3 along = first.normalized();
  const Vec3 across = first.cross(second).cross(first).normalized();
  std::vector<Vec2> flat;
  for (const Vec3& x : nodes) {
    flat.emplace_back((x - centre).dot(along) / first.norm(),
                      (x - centre).dot(across) / first.norm());
  }
  return flat;
}

/// Adds the integrals of 1, x and y times the shape functions of a face [3, its nodes].
void add_moments(base::ElementType type, std::span<const std::size_t> nodes,
                 const std::vector<Vec2>& x, double factor, Matrix& moments) {
  constexpr int degree = 7; // of shape functions, place and determinant on curved sides
  const shape::ReferenceElement<2>& face = shape::reference_element<2>(type);
  for (const auto& point : shape::quadrature<2>(face.domain, degree)) {
    const auto N = face.N(point.r);
    const auto dN = face.dN(point.r);
    Vec3 linear(1.0, 0.0, 0.0);
    Eigen::Matrix2d J = Eigen::Matrix2d::Zero();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      linear.tail<2>() += N[k] * x[nodes[i]];
      J += x[nodes[i]] * dN.row(k);
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      moments.col(static_cast<Eigen::Index>(nodes[i])) +=
          factor * point.weight * J.determinant() * N[static_cast<Eigen::Index>(i)] * linear;
    }
  }
}

} // namespace

Matrix quadrilateral_tie_weights(std::span<const Vec3> nodes) {
  assert(nodes.size() == middle || nodes.size() == middle + 1);
  const base::ElementType type =
      nodes.size() == middle ? base::ElementType::quamc8 : base::ElementType::quamc9;
  const shape::ReferenceElement<2>& face = shape::reference_element<2>(type);
  const auto own = static_cast<Eigen::Index>(nodes.size());
  const Eigen::Index others = 13 - own;
  Matrix weights(others, own);
  if (nodes.size() == middle) {
    weights.row(0) = face.N(face.centre()).transpose();
  }
  for (int corner = 0; corner < 4; ++corner) {
    weights.row(others - 4 + corner) = face.N(0.5 * face.node_coordinates(corner)).transpose();
  }
  std::vector<Vec2> x = flatten(nodes);
  for (Eigen::Index s = 0; s < others; ++s) {
    Vec2 place = Vec2::Zero();
    for (Eigen::Index i = 0; i < own; ++i) {
      place += weights(s, i) * x[static_cast<std::size_t>(i)];
    }
    x.push_back(place);
  }
  // What the quadrilateral has more than the triangles.
  Matrix moments = Matrix::Zero(3, own + others);
  std::vector<std::size_t> all(nodes.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  add_moments(type, all, x, 1.0, moments);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    const std::array<std::size_t, 6> triangle{
        i, next, middle, 4 + i, middle + 1 + next, middle + 1 + i};
    add_moments(base::ElementType::trimc6, triangle, x, -1.0, moments);
  }
  const auto of_others = moments.rightCols(others);
  const Matrix missing = moments.leftCols(own) + of_others * weights;
  const Eigen::Matrix3d product = of_others * of_others.transpose();
  weights -= of_others.transpose() * product.ldlt().solve(missing);
  return weights;
}

} // namespace spricka::mesh
