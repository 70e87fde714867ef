// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/element.hpp"
#include "model/mesh.hpp"
#include "shape/topology.hpp"

#include <Eigen/Geometry>

#include <vector>

/// Kernels of one side of an element.
namespace spricka::fe {

/// Degree of exactness of loads: fields of x y z and the roots in the length of curved sides are no
/// polynomials, so that more is taken than the stiffness needs.
inline constexpr int load_degree = 9;

/// Mesh nodes of a side, corners first.
inline std::vector<base::NodeId> collect_face_nodes(const model::Mesh& mesh,
                                                    const model::Face& face) {
  const std::span<const base::NodeId> nodes = mesh.element_nodes(face.element);
  std::vector<base::NodeId> result;
  for (const int i : shape::side_nodes(mesh.type[face.element.index()], face.side)) {
    result.push_back(nodes[static_cast<std::size_t>(i)]);
  }
  return result;
}

/// A side of a plane element (dim = 1) or of a solid (dim = 2).
template <int dim> struct ElementSide {
  std::vector<base::NodeId> nodes; ///< of the mesh, corners first
  const AnyElement<dim>& shape;
  SpaceNodes<dim> X; ///< where they are

  ElementSide(const model::Mesh& mesh, const model::Face& face)
      : nodes(collect_face_nodes(mesh, face)),
        shape(shape_of(mesh.type[face.element.index()], face.side, nodes.size())),
        X(3, shape.nodes) {
    Eigen::Index i = 0;
    for (const base::NodeId n : nodes) {
      X.col(i++) = mesh.x[n.index()];
    }
  }

private:
  static const AnyElement<dim>& shape_of(base::ElementType type, int side, std::size_t count) {
    if constexpr (dim == 1) {
      return shape::reference_line(static_cast<int>(count));
    } else {
      return shape::reference_element<2>(shape::solid_side_type(type, side));
    }
  }
};

/// Outer normal times the area that belongs to a unit of the reference side (for an edge: per unit
/// of thickness). Edges run with the body on their left.
template <int dim> base::Vec3 area_vector(const Eigen::Matrix<double, 3, dim>& tangents) {
  if constexpr (dim == 1) {
    return {tangents(1, 0), -tangents(0, 0), 0.0};
  } else {
    return tangents.col(0).cross(tangents.col(1));
  }
}
template <int dim>
base::Vec3 area_vector(const AnyElement<dim>& side, const SpaceNodes<dim>& X,
                       const shape::Point<dim>& r) {
  return area_vector<dim>(X.lazyProduct(side.dN(r)));
}

/// Calls f(side, X) with the reference element of a side and the coordinates of its nodes; f is a
/// generic lambda `[&]<int dim>(const AnyElement<dim>& side, const SpaceNodes<dim>& X)`.
template <class F> void with_any_side(const model::Mesh& mesh, const model::Face& face, F&& f) {
  if (base::element_info(mesh.type[face.element.index()]).dim == 2) {
    const ElementSide<1> side(mesh, face);
    f(side.shape, side.X);
  } else {
    const ElementSide<2> side(mesh, face);
    f(side.shape, side.X);
  }
}

} // namespace spricka::fe
