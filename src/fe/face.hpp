// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/element.hpp"
#include "model/mesh.hpp"
#include "shape/topology.hpp"

#include <Eigen/Geometry>

/// Kernels of one side of an element.
namespace spricka::fe {

/// Degree of exactness of loads: fields of x y z and the roots in the length of curved sides are no
/// polynomials, so that more is taken than the stiffness needs.
inline constexpr int load_degree = 9;

/// Coordinates of the nodes of a side in space [3, side nodes].
template <shape::Shape Side> using SideNodes = Eigen::Matrix<double, 3, Side::nodes>;

/// Mesh nodes of a side, corners first.
template <shape::Shape Side>
std::array<base::NodeId, Side::nodes> nodes_of_face(const model::Mesh& mesh,
                                                    const model::Face& face) {
  const std::span<const base::NodeId> nodes = mesh.nodes_of(face.element);
  const std::span<const int> local = shape::side_nodes(mesh.type[face.element.index()], face.side);
  assert(local.size() == static_cast<std::size_t>(Side::nodes));
  std::array<base::NodeId, Side::nodes> result;
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = nodes[static_cast<std::size_t>(local[i])];
  }
  return result;
}

template <shape::Shape Side>
SideNodes<Side> side_coordinates(const model::Mesh& mesh, const model::Face& face) {
  SideNodes<Side> X;
  Eigen::Index i = 0;
  for (const base::NodeId n : nodes_of_face<Side>(mesh, face)) {
    X.col(i++) = mesh.x[n.index()];
  }
  return X;
}

/// Outer normal times the area that belongs to a unit of the reference side (for an edge: per unit
/// of thickness). Edges run with the body on their left.
template <shape::Shape Side>
base::Vec3 area_vector(const SideNodes<Side>& X, const shape::Point<Side::dim>& r) {
  const Eigen::Matrix<double, 3, Side::dim> T = X * Side::dN(r);
  if constexpr (Side::dim == 1) {
    return {T(1, 0), -T(0, 0), 0.0};
  } else {
    return T.col(0).cross(T.col(1));
  }
}

/// Calls f(Side{}) with the shape of a side.
template <class F> void with_side(const model::Mesh& mesh, const model::Face& face, F&& f) {
  const base::ElementType type = mesh.type[face.element.index()];
  if (base::info(type).dim == 2) {
    shape::with_plane_shape(type, [&]<shape::PlaneShape S>(S) { f(typename S::Side{}); });
  } else {
    shape::with_plane_shape(shape::solid_side(type, face.side),
                            [&]<shape::PlaneShape Side>(Side side) { f(side); });
  }
}

/// Calls f(Side{}, face) for each face with the shape of the side.
template <class F>
void for_faces(const model::Mesh& mesh, const std::vector<model::Face>& faces, F&& f) {
  for (const model::Face& face : faces) {
    with_side(mesh, face, [&]<shape::Shape Side>(Side side) { f(side, face); });
  }
}

/// The same where all faces are edges of plane elements.
template <class F>
void for_edges(const model::Mesh& mesh, const std::vector<model::Face>& faces, F&& f) {
  for (const model::Face& face : faces) {
    shape::with_plane_shape(mesh.type[face.element.index()],
                            [&]<shape::PlaneShape S>(S) { f(typename S::Side{}, face); });
  }
}

} // namespace spricka::fe
