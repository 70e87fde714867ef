// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/disjoint_sets.hpp"
#include "deck/context.hpp"
#include "deck/element_place.hpp"
#include "mesh/boundary.hpp"
#include "mesh/cut/coincidence.hpp"
#include "mesh/side_index.hpp"
#include "model/mesh_side.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

/// Elements that stand twice, and bodies that touch along whole sides but are joined by nothing.
namespace spricka::deck {

namespace {

using base::NodeId;

void doubled(DeckContext& c) {
  auto pairs = mesh::find_coincident_elements(c.model.mesh);
  std::erase_if(pairs, [&](const auto& pair) { // bodies of their own may be drawn on each other
    return c.model.mesh.element_net[pair.first.index()] !=
           c.model.mesh.element_net[pair.second.index()];
  });
  if (pairs.empty()) {
    return;
  }
  const auto& [first, second] = pairs.front();
  const auto label = [&](base::ElementId e) { return c.model.mesh.element_label[e.index()]; };
  const std::string more = pairs.size() > 1 ? fmt::format(" and {} more", pairs.size() - 1) : "";
  c.error(element_source_span(c, second.index()), "E340",
          fmt::format("element {}{} lies on element {}: the material would count twice",
                      label(second), more, label(first)),
          "is an $ELEMENT, $MESH or $IMPORT there twice?");
}

// Nodes that a contact or a tie looks after.
std::vector<bool> looked_after(const DeckContext& c) {
  const model::Mesh& mesh = c.model.mesh;
  std::vector<bool> found(mesh.node_count(), false);
  const auto faces = [&](base::FaceSetId set) {
    if (set.valid()) {
      for (const NodeId n : mesh::nodes_of_faces(mesh, mesh.set_with_id(set).faces)) {
        found[n.index()] = true;
      }
    }
  };
  const auto nodes = [&](base::NodeSetId set) {
    if (set.valid()) {
      for (const NodeId n : mesh.set_with_id(set).nodes) {
        found[n.index()] = true;
      }
    }
  };
  for (const model::Contact& contact : c.model.contacts) {
    faces(contact.slave);
    faces(contact.master);
  }
  for (const model::Mpc& mpc : c.model.mpcs) {
    if (const auto* equation = std::get_if<model::ConstraintEquation>(&mpc)) {
      for (const model::ConstraintEquation::ConstraintTerm& term : equation->terms) {
        found[term.node.index()] = true;
      }
    } else if (const auto* tie = std::get_if<model::TransitionTie>(&mpc)) {
      nodes(tie->slave);
      faces(tie->master);
    } else if (const auto* rigid = std::get_if<model::RigidTie>(&mpc)) {
      nodes(rigid->slave);
    }
  }
  return found;
}

// The faces of a crack of the user's own mesh are meant to touch: they hang together with the front
// that its card names.
void take_out_cracks(const model::Model& model, std::vector<mesh::CoincidentFacePair>& seams) {
  const model::Mesh& mesh = model.mesh;
  base::DisjointSets joined(mesh.node_count());
  for (const mesh::CoincidentFacePair& seam : seams) {
    const std::vector<NodeId> nodes = mesh::nodes_of_faces(mesh, {seam.first, seam.second});
    for (const NodeId node : nodes) {
      joined.join_sets(nodes.front().index(), node.index());
    }
  }
  std::set<std::size_t> cracks;
  for (const model::CrackDefinition& crack : model.cracks) {
    if (crack.is_in_mesh() && crack.path.valid()) {
      for (const NodeId node : mesh.set_with_id(crack.path).nodes) {
        cracks.insert(joined.root(node.index()));
      }
    }
  }
  std::erase_if(seams, [&](const mesh::CoincidentFacePair& seam) {
    const NodeId node = mesh::nodes_of_faces(mesh, {seam.first}).front();
    return cracks.contains(joined.root(node.index()));
  });
}

// A slit that is meant is told like one that is not: only its maker knows.
void open_seams(DeckContext& c) {
  const model::Mesh& mesh = c.model.mesh;
  if (!c.boundary) {
    c.boundary = mesh::boundary_faces(mesh);
  }
  std::vector<mesh::CoincidentFacePair> seams = mesh::find_coincident_faces(mesh, *c.boundary);
  if (seams.empty()) {
    return;
  }
  const std::vector<bool> known = looked_after(c);
  std::erase_if(seams, [&](const mesh::CoincidentFacePair& seam) {
    return mesh.element_net[seam.first.element.index()] !=
               mesh.element_net[seam.second.element.index()] ||
           mesh::face_has_all_nodes_inside(mesh, seam.first, known) ||
           mesh::face_has_all_nodes_inside(mesh, seam.second, known);
  });
  take_out_cracks(c.model, seams);
  if (seams.empty()) {
    return;
  }
  const mesh::CoincidentFacePair& seam = seams.front();
  const auto net = [&](const model::Face& face) {
    const std::string& name = c.model.nets[mesh.element_net[face.element.index()].index()].name;
    return name.empty() ? std::string() : " of " + name;
  };
  const auto label = [&](const model::Face& face) {
    return mesh.element_label[face.element.index()];
  };
  c.warning(
      element_source_span(c, seam.second.element.index()), "W341",
      fmt::format("elements {} and {}{} touch along a side but have nodes of their own there{}: "
                  "nothing joins them",
                  label(seam.first), label(seam.second), net(seam.first),
                  seams.size() > 1 ? fmt::format(", like {} more pairs", seams.size() - 1) : ""),
      "give both the same nodes, tie them with $MPC or pair the sides with $CONTACT; a slit stays "
      "open and its faces may pass through each other");
}

// Where a side of a quadratic element has middle nodes that its linear neighbour does not have, the
// two part between the corners.
void hanging_nodes(DeckContext& c) {
  const model::Mesh& mesh = c.model.mesh;
  const auto is_linear = [](base::ElementType type) { return !base::element_info(type).quadratic; };
  const auto linear = std::ranges::count_if(mesh.type, is_linear);
  if (linear == 0 || static_cast<std::size_t>(linear) == mesh.element_count()) {
    return;
  }
  const mesh::SideIndex sides(mesh);
  const std::vector<bool> known = looked_after(c);
  std::optional<std::pair<base::ElementId, base::ElementId>> first;
  std::size_t count = 0;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const base::ElementType type = mesh.type[e];
    for (int side = 0; is_linear(type) && side < base::element_info(type).sides; ++side) {
      const std::vector<NodeId> corners = model::side_nodes(mesh, {base::ElementId(e), side});
      for (const model::Face& other : sides.find(corners)) {
        if (!is_linear(mesh.type[other.element.index()]) &&
            !mesh::face_has_all_nodes_inside(mesh, other, known)) {
          first = first ? first : std::optional(std::pair(base::ElementId(e), other.element));
          ++count;
        }
      }
    }
  }
  if (first) {
    const auto label = [&](base::ElementId e) { return mesh.element_label[e.index()]; };
    const auto name = [&](base::ElementId e) {
      return base::element_info(mesh.type[e.index()]).name;
    };
    c.warning(
        element_source_span(c, first->first.index()), "W370",
        fmt::format("element {} ({}) has a side in common with element {} ({}), whose middle nodes "
                    "there hang free{}: between the corners the two part or overlap",
                    label(first->first), name(first->first), label(first->second),
                    name(first->second),
                    count > 1 ? fmt::format(", as at {} more sides", count - 1) : ""),
        "give all elements of a body the same order; meshes of two orders have nodes of their own "
        "and are tied by $MPC TYPE=TRANSITION or a bonded contact");
  }
}

} // namespace

void check_double_and_unjoined_elements(DeckContext& context) {
  if (!context.mesh_sound || context.diagnostics.has_errors() ||
      context.model.mesh.element_count() == 0) {
    return;
  }
  doubled(context);
  open_seams(context);
  hanging_nodes(context);
}

} // namespace spricka::deck
