// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/sets.hpp"

#include "deck/items.hpp"
#include "deck/set_builder.hpp"
#include "mesh/boundary.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

// Sets that the card of another one names.
SetFinder finder(Context& c) {
  return {[&c](const Reference& reference) { return use_node_set(c, reference); },
          [&c](const Reference& reference) { return use_element_set(c, reference); },
          [&c](const Reference& reference) { return use_face_set(c, reference); }};
}

// The definition of a set, its card built if it has not been yet.
const Definition* find_set(Context& c, Kind kind, const Reference& reference) {
  const Definition* found = look_up(c, kind, reference);
  if (found == nullptr || !found->card) {
    return found;
  }
  const std::size_t card = *found->card;
  if (std::find(c.building.begin(), c.building.end(), card) != c.building.end()) {
    c.error(reference.span, "E310", fmt::format("set {} is made of itself", reference.name));
    return nullptr;
  }
  c.building.push_back(card);
  build_set(c, c.cards[card], finder(c));
  c.building.pop_back();
  return found->poisoned ? nullptr : found;
}

} // namespace

std::optional<Kind> kind_of_set(Context& context, Kind kind, const Reference& reference) {
  const Definition* found = find_set(context, kind, reference);
  return found == nullptr ? std::nullopt : std::optional(found->kind);
}

std::optional<base::NodeSetId> use_node_set(Context& context, const Reference& reference) {
  const Definition* found = find_set(context, Kind::set, reference);
  if (found == nullptr) {
    return std::nullopt;
  }
  if (found->kind == Kind::node_set) {
    return base::NodeSetId(found->index);
  }
  const auto [it, fresh] = context.nodes_of_faces.try_emplace(found->index);
  if (fresh) {
    model::Mesh& mesh = context.model.mesh;
    const model::FaceSet& faces = mesh.face_sets[found->index];
    it->second = base::NodeSetId(mesh.node_sets.size());
    mesh.node_sets.push_back({faces.name, mesh::nodes_of_faces(mesh, faces.faces), faces.span});
  }
  return it->second;
}

std::optional<base::FaceSetId> use_face_set(Context& context, const Reference& reference) {
  const Definition* found = find_set(context, Kind::face_set, reference);
  if (found == nullptr) {
    return std::nullopt;
  }
  if (found->kind == Kind::face_set) {
    return base::FaceSetId(found->index);
  }
  if (const auto it = context.faces_of_nodes.find(found->index);
      it != context.faces_of_nodes.end()) {
    return it->second;
  }
  model::Mesh& mesh = context.model.mesh;
  const model::NodeSet& nodes = mesh.node_sets[found->index];
  std::vector<model::Face> faces = boundary_within(context, nodes.nodes);
  if (faces.empty()) {
    if (context.mesh_sound) {
      context.error(reference.span, "E311",
                    fmt::format("no boundary face has all its nodes in set {}", reference.name));
    }
    return std::nullopt;
  }
  const base::FaceSetId id(mesh.face_sets.size());
  mesh.face_sets.push_back({nodes.name, std::move(faces), nodes.span});
  context.faces_of_nodes.emplace(found->index, id);
  return id;
}

std::optional<base::ElementSetId> use_element_set(Context& context, const Reference& reference) {
  const Definition* found = find_set(context, Kind::element_set, reference);
  return found == nullptr ? std::nullopt : std::optional(base::ElementSetId(found->index));
}

std::optional<std::vector<base::NodeId>> node_items(Context& context, const BoundCard& card) {
  Collection collection(context.model.mesh.node_count());
  if (!read_items(context, card, Kind::node_set, finder(context), collection)) {
    return std::nullopt;
  }
  const std::vector<std::size_t> indices = collection.take();
  return std::vector<base::NodeId>(indices.begin(), indices.end());
}

std::optional<Reference> set_field(Context& context, const BoundCard& card,
                                   const grammar::Field& field) {
  if (field.kind == grammar::Field::Kind::name) {
    return Reference{field.text, field.span, card.net};
  }
  context.error(field.span, "E115", "the name of a set is expected",
                std::string(card.spec->data_form));
  return std::nullopt;
}

void build_sets(Context& context) {
  for (const BoundCard& card : context.cards) {
    if (card.bad ||
        (card.spec->name != "NSET" && card.spec->name != "ESET" && card.spec->name != "FSET")) {
      continue;
    }
    const BoundValue& name = *card.find("NAME");
    const Reference reference{qualify(card.net, name.text), name.span, {}};
    const Definition* found = context.names.find({name.key->kind}, reference.name, {});
    if (found == nullptr || found->poisoned) {
      continue;
    }
    if (name.key->kind == Kind::element_set) {
      use_element_set(context, reference);
    } else {
      kind_of_set(context, name.key->kind, reference);
    }
  }
}

} // namespace spricka::deck
