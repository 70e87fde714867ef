// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/mouth.hpp"

#include "mesh/plane.hpp"

#include <cmath>

namespace spricka::mesh {

using base::NodeId;
using base::Vec2;
using base::Vec3;

NearestMouth find_crack_mouth(const HostMesh& host, const Vec3& start, base::NetId net) {
  constexpr double at_node = 1e-6; // of the edge: a mouth this near to a node is at the node
  const model::Mesh& mesh = host.mesh();
  NearestMouth found;
  for (const model::Face& face : host.boundary()) {
    if (!is_face_element_in_net(mesh, face, net)) {
      continue;
    }
    const EdgeEndAndMidNodes edge = element_edge_nodes(mesh, face);
    const double chord = (mesh.x[edge.b.index()] - mesh.x[edge.a.index()]).norm();
    if (is_edge_beyond_distance_of_point(mesh, edge, start, found.distance)) {
      continue;
    }
    const NearestEdgePoint p = nearest_point_on_edge(mesh, edge, start);
    // At a node two edges are equally near: the first one counts, not the better by round-off.
    if (p.distance < found.distance - 1e-9 * chord) {
      found = {{face, p.xi, {}}, point_on_edge(mesh, edge, p.xi), p.distance, chord};
    }
  }
  if (found.on_boundary()) {
    const EdgeEndAndMidNodes edge = element_edge_nodes(mesh, found.mouth.face);
    for (const NodeId n : {edge.a, edge.b, edge.mid}) {
      if (n.valid() && (mesh.x[n.index()] - found.at).norm() <= at_node * found.chord) {
        found.mouth.node = n;
        found.at = mesh.x[n.index()];
      }
    }
  }
  return found;
}

base::ElementId find_element_at(const model::Mesh& mesh, const Vec3& point, base::NetId net) {
  for (std::size_t i = 0; i < mesh.element_count(); ++i) {
    const base::ElementId e(i);
    if (net.valid() && mesh.element_net[i] != net) {
      continue;
    }
    const Vec3& first = mesh.x[mesh.element_nodes(e).front().index()];
    const double size = (mesh.x[mesh.element_nodes(e)[1].index()] - first).norm();
    // A frame at the point in sizes of the element, so that `same` is a part of the element.
    const std::vector<Vec2> shape =
        element_polygon_in_frame(mesh, e, {point, Eigen::Matrix3d::Identity(), size});
    if (distance(shape, {Vec2::Zero(), Vec2::Zero()}) < coordinate_tolerance) {
      return e;
    }
  }
  return {};
}

CrackStartLocation locate_crack_start(const HostMesh& host, const Vec3& point, base::NetId net) {
  const NearestMouth found = find_crack_mouth(host, point, net);
  if (found.on_boundary()) {
    return CrackStartLocation::boundary;
  }
  return find_element_at(host.mesh(), point, net).valid() ? CrackStartLocation::inside
                                                          : CrackStartLocation::outside;
}

} // namespace spricka::mesh
