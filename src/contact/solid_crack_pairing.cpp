// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solid_crack_pairing.hpp"

#include "contact/make_rows.hpp"
#include "contact/pair_points.hpp"
#include "contact/space/twin_projection.hpp"

#include <set>
#include <utility>

namespace spricka::contact {

namespace {

// Where the function of each front node of a face goes: that of a corner to the next node of an
// edge that leaves the front (a quarter point), that of a middle on the front across the face.
void find_behind(const geometry::ElementSide& face, const std::set<base::NodeId>& front,
                 NodesBehindFront& behind) {
  const auto corners = static_cast<std::size_t>(face.corner_count());
  const bool quadratic = face.nodes.size() > corners;
  const auto on_front = [&](std::size_t n) { return front.contains(face.nodes[n]); };
  for (std::size_t c = 0; c < corners; ++c) {
    const std::size_t next = (c + 1) % corners;
    if (on_front(c) != on_front(next)) {
      const std::size_t end = on_front(c) ? c : next;
      const std::size_t other = on_front(c) ? next : c;
      behind.try_emplace(face.nodes[end], face.nodes[quadratic ? corners + c : other]);
    }
    if (quadratic && on_front(corners + c)) {
      const std::size_t across = corners == 4 ? corners + (c + 2) % corners : (c + 2) % corners;
      behind.try_emplace(face.nodes[corners + c], face.nodes[across]);
    }
  }
}

} // namespace

PairConstraints build_solid_crack_constraints(const model::Model& model, const model::Mesh& mesh,
                                              const mesh::CrackFaceNodes& crack_faces,
                                              bool friction) {
  PairConstraints pair;
  pair.faces = true;
  pair.choice = "upper face: twins";
  pair.contact = make_contact_surface(model, mesh, crack_faces.left_sides);
  pair.target = make_contact_surface(model, mesh, crack_faces.right_sides);
  if (!match_coincident_faces(pair.contact, pair.target)) {
    pair.trouble = "the faces of the crack do not lie on one another node by node";
    return pair;
  }
  std::set<base::NodeId> front;
  for (std::size_t i = 0; i < crack_faces.left.size(); ++i) {
    if (crack_faces.left[i] == crack_faces.right[i]) {
      front.insert(crack_faces.left[i]);
    }
  }
  NodesBehindFront behind;
  for (const geometry::ElementSide& face : pair.contact.facets) {
    find_behind(face, front, behind);
  }
  fill_mortar_rows(pair, make_target_projector(pair),
                   {.declared_gap = 0.0, .tangents = friction, .at_front = std::move(behind)});
  return pair;
}

} // namespace spricka::contact
