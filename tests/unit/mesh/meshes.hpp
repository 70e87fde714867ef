// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"
#include "shape/quadrature.hpp"
#include "shape/reference_element.hpp"
#include "shape/topology.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace spricka::test {

template <int dim> double area(const model::Mesh& mesh, base::ElementId e) {
  const shape::ReferenceElement<dim>& element = shape::reference_element<dim>(mesh.type[e.index()]);
  double sum = 0.0;
  for (const auto& q : shape::quadrature<dim>(element.domain, 7)) {
    Eigen::Matrix<double, dim, dim> J = Eigen::Matrix<double, dim, dim>::Zero();
    const auto d = element.dN(q.r);
    Eigen::Index i = 0;
    for (const base::NodeId n : mesh.element_nodes(e)) {
      J += d.row(i++).transpose() * mesh.x[n.index()].template head<dim>().transpose();
    }
    sum += q.weight * J.determinant();
  }
  return sum;
}

/// Area of plane elements or volume of solids, exact for curved ones (the determinant is a
/// polynomial).
inline double area(const model::Mesh& mesh) {
  double sum = 0.0;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const base::ElementId id(e);
    sum += base::element_info(mesh.type[e]).dim == 2 ? area<2>(mesh, id) : area<3>(mesh, id);
  }
  return sum;
}

inline const model::FaceSet& faces(const model::Mesh& mesh, const std::string& name) {
  const auto at = std::find_if(mesh.face_sets.begin(), mesh.face_sets.end(),
                               [&](const model::FaceSet& s) { return s.name == name; });
  if (at == mesh.face_sets.end()) {
    throw std::runtime_error("no face set " + name);
  }
  return *at;
}

inline std::vector<base::NodeId> nodes_of(const model::Mesh& mesh, const model::Face& face) {
  std::vector<base::NodeId> result;
  for (const int i : shape::side_nodes(mesh.type[face.element.index()], face.side)) {
    result.push_back(mesh.element_nodes(face.element)[static_cast<std::size_t>(i)]);
  }
  return result;
}

/// Length of the chords of some faces.
inline double chord_length(const model::Mesh& mesh, const std::vector<model::Face>& some) {
  double sum = 0.0;
  for (const model::Face& face : some) {
    const auto nodes = nodes_of(mesh, face);
    sum += (mesh.x[nodes[1].index()] - mesh.x[nodes[0].index()]).norm();
  }
  return sum;
}

} // namespace spricka::test
