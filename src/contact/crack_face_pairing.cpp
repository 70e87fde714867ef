// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/crack_face_pairing.hpp"

#include "contact/node_pair.hpp"
#include "mesh/boundary.hpp"
#include "shape/quadrature.hpp"

#include <algorithm>
#include <map>

namespace spricka::contact {

namespace {

// Of the largest share of a face that a node has: less is round-off.
constexpr double no_area = 1e-9;

// What a unit pressure on the face puts on its nodes, and their order along it.
struct PushedNodes {
  std::map<base::NodeId, Vec2> push; ///< along the outer normal [area]
  std::vector<base::NodeId> order;
};

// `depth` of a place.
template <class Depth> PushedNodes face_nodes(const ContactSurface& surface, Depth&& depth) {
  PushedNodes nodes;
  for (const Edge& edge : surface.plane.edges) {
    for (const std::size_t i : {std::size_t{0}, std::size_t{2}, std::size_t{1}}) {
      if (static_cast<int>(i) >= edge.count) {
        continue;
      }
      const auto [at, fresh] = nodes.push.try_emplace(edge.nodes[i], Vec2::Zero());
      if (fresh) {
        nodes.order.push_back(edge.nodes[i]);
      }
      // exact for straight edges with a quarter point: N times the Jacobian is of degree 3, times
      // a radius of degree 5
      for (const auto& [r, weight] : shape::line_rule(5)) {
        const Vec2 t = tangent_on(edge, r[0]);
        at->second +=
            depth(point_on(edge, r[0])) * weight * edge_N(edge, r[0])[i] * Vec2(t.y(), -t.x());
      }
    }
  }
  return nodes;
}

ContactSurface face_surface(const model::Model& model, const model::Mesh& mesh,
                            const std::vector<base::NodeId>& crack_face) {
  ContactSurface surface = make_surface(model, mesh, mesh::faces_within(mesh, crack_face));
  surface.circle.reset(); // places along a face are lengths, also where it is an arc
  return surface;
}

} // namespace

PairConstraints crack_face_rows(const model::Model& model, const model::Mesh& mesh,
                                const mesh::CrackFaces& crack_faces, bool friction) {
  const bool half = crack_faces.has_one_face();
  const std::vector<base::NodeId>& own = crack_faces.meshed_face();
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
  for (const auto& [left, right] : crack_faces.node_pairs()) {
    opposite[left] = right;
  }
  for (std::size_t i = 0; half && i + 1 < own.size(); ++i) {
    opposite[own[i]] = base::NodeId();
  }
  const PushedNodes nodes = face_nodes(pair.contact, [&](const Vec2& x) {
    return out_of_plane_depth(pair.contact, pair.target, x);
  });
  double largest = 0.0;
  for (const auto& [id, push] : nodes.push) {
    largest = std::max(largest, push.norm());
  }
  for (const base::NodeId id : nodes.order) {
    const auto other = opposite.find(id);
    if (other == opposite.end()) {
      continue;
    }
    const Vec2& push = nodes.push.at(id);
    if (push.norm() <= no_area * largest) {
      continue; // the corner of a quadratic edge on the axis
    }
    append_node_rows(NodePair{id, other->second, base::to_space(push), push.norm(), 0.0},
                     friction && !half, pair);
  }
  return pair;
}

} // namespace spricka::contact
