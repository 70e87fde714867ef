// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/crack_face_pairing.hpp"

#include "base/index.hpp"
#include "contact/node_pair.hpp"
#include "mesh/boundary.hpp"

#include <algorithm>
#include <map>

namespace spricka::contact {

namespace {

// Of the largest share of a face that a node has: less is round-off.
constexpr double no_area = 1e-9;

// What a unit pressure on the face of a pair puts on its nodes, along the outer normal. [area]
std::map<base::NodeId, base::Vec3> pushed_nodes(const PairConstraints& pair) {
  // exact for straight edges with a quarter point: N times the Jacobian is of degree 3, times a
  // radius of degree 5
  constexpr int degree = 5;
  std::map<base::NodeId, base::Vec3> push;
  for (const geometry::ElementSide& edge : pair.contact.facets) {
    edge.for_quadrature_points(degree, [&](const Vec2& r, double weight) {
      const geometry::SidePoint at = edge.point(r);
      const geometry::SideValues N = edge.N(r);
      const double w = weight * out_of_plane_depth(pair.contact, pair.target, at.x.head<2>());
      for (std::size_t i = 0; i < edge.nodes.size(); ++i) {
        push.try_emplace(edge.nodes[i], base::Vec3::Zero()).first->second +=
            w * N[base::index(i)] * at.area_vector();
      }
    });
  }
  return push;
}

ContactSurface face_surface(const model::Model& model, const model::Mesh& mesh,
                            const std::vector<base::NodeId>& crack_face) {
  ContactSurface surface =
      make_contact_surface(model, mesh, mesh::boundary_faces_with_all_nodes_in(mesh, crack_face));
  surface.circle.reset(); // places along a face are lengths, also where it is an arc
  return surface;
}

} // namespace

PairConstraints build_crack_face_constraints(const model::Model& model, const model::Mesh& mesh,
                                             const mesh::CrackFaceNodes& crack_faces,
                                             bool friction) {
  const bool half = crack_faces.has_one_face();
  const std::vector<base::NodeId>& own = crack_faces.meshed_face_nodes();
  PairConstraints pair;
  pair.faces = true;
  pair.found = true;
  pair.choice = half ? "the face of a half model, against its line" : "left face: node pairs";
  pair.contact = face_surface(model, mesh, own);
  // A half model has no other face: rows weigh its own nodes alone, and out_of_plane_depth() finds
  // their thickness on both sides.
  if (half) {
    pair.target.thickness = pair.contact.thickness;
  } else {
    pair.target = face_surface(model, mesh, crack_faces.right);
  }
  std::map<base::NodeId, base::NodeId> opposite; // the tips are left out
  for (const auto& [left, right] : crack_faces.coincident_node_pairs()) {
    opposite[left] = right;
  }
  for (std::size_t i = 0; half && i + 1 < own.size(); ++i) {
    opposite[own[i]] = base::NodeId();
  }
  const std::map<base::NodeId, base::Vec3> pushes = pushed_nodes(pair);
  double largest = 0.0;
  for (const auto& [id, push] : pushes) {
    largest = std::max(largest, push.norm());
  }
  for (const auto& [part, id] : smooth_part_nodes(pair.contact)) {
    const auto other = opposite.find(id);
    const base::Vec3& push = pushes.at(id);
    if (other == opposite.end() || push.norm() <= no_area * largest) {
      continue; // the corner of a quadratic edge on the axis
    }
    NodePair nodes{id, other->second, {push}, push.norm(), 0.0};
    if (friction && !half) {
      nodes.push.push_back(base::Vec3::UnitZ().cross(push)); // turned to the left
    }
    append_node_rows(nodes, pair);
  }
  return pair;
}

} // namespace spricka::contact
