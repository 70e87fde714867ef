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
SetFinder finder(DeckContext& c) {
  return {[&c](const NameReference& reference) { return resolve_node_set(c, reference); },
          [&c](const NameReference& reference) { return resolve_element_set(c, reference); },
          [&c](const NameReference& reference) { return resolve_face_set(c, reference); }};
}

// The definition of a set, its card built if it has not been yet.
const NameDefinition* find_set(DeckContext& c, EntityKind kind, const NameReference& reference) {
  const NameDefinition* found = find_referenced_definition(c, kind, reference);
  if (found == nullptr || !found->card) {
    return found;
  }
  const std::size_t card = *found->card;
  if (std::ranges::find(c.building, card) != c.building.end()) {
    c.error(reference.span, "E310", fmt::format("set {} is made of itself", reference.name));
    return nullptr;
  }
  c.building.push_back(card);
  build_set(c, c.cards[card], finder(c));
  c.building.pop_back();
  return found->poisoned ? nullptr : found;
}

} // namespace

std::optional<EntityKind> resolve_set_kind(DeckContext& context, EntityKind kind,
                                           const NameReference& reference) {
  const NameDefinition* found = find_set(context, kind, reference);
  return found == nullptr ? std::nullopt : std::optional(found->kind);
}

std::optional<base::NodeSetId> resolve_node_set(DeckContext& context,
                                                const NameReference& reference) {
  const NameDefinition* found = find_set(context, EntityKind::set, reference);
  if (found == nullptr) {
    return std::nullopt;
  }
  if (found->kind == EntityKind::node_set) {
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

std::optional<base::FaceSetId> resolve_face_set(DeckContext& context,
                                                const NameReference& reference) {
  const NameDefinition* found = find_set(context, EntityKind::face_set, reference);
  if (found == nullptr) {
    return std::nullopt;
  }
  if (found->kind == EntityKind::face_set) {
    return base::FaceSetId(found->index);
  }
  if (const auto it = context.faces_of_nodes.find(found->index);
      it != context.faces_of_nodes.end()) {
    return it->second;
  }
  model::Mesh& mesh = context.model.mesh;
  const model::NodeSet& nodes = mesh.node_sets[found->index];
  std::vector<model::Face> faces = cached_boundary_faces_within(context, nodes.nodes);
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

std::optional<base::ElementSetId> resolve_element_set(DeckContext& context,
                                                      const NameReference& reference) {
  const NameDefinition* found = find_set(context, EntityKind::element_set, reference);
  return found == nullptr ? std::nullopt : std::optional(base::ElementSetId(found->index));
}

std::optional<std::vector<base::NodeId>> collect_listed_nodes(DeckContext& context,
                                                              const CheckedCard& card) {
  OrderedIndexSet collection(context.model.mesh.node_count());
  if (!read_listed_members(context, card, EntityKind::node_set, finder(context), collection)) {
    return std::nullopt;
  }
  const std::vector<std::size_t> indices = collection.collected_indices();
  return std::vector<base::NodeId>(indices.begin(), indices.end());
}

std::optional<NameReference> read_set_name_field(DeckContext& context, const CheckedCard& card,
                                                 const grammar::CardField& field) {
  if (field.is_name()) {
    return NameReference{field.text, field.span, card.net};
  }
  context.error(field.span, "E115", "the name of a set is expected",
                std::string(card.spec->data_form));
  return std::nullopt;
}

void build_sets(DeckContext& context) {
  for (const CheckedCard& card : context.cards) {
    if (card.bad ||
        (card.spec->name != "NSET" && card.spec->name != "ESET" && card.spec->name != "FSET")) {
      continue;
    }
    const CheckedValue& name = *card.find("NAME");
    const NameReference reference{qualified_name(card.net, name.text), name.span, {}};
    const NameDefinition* found = context.names.find({name.key->kind}, reference.name, {});
    if (found == nullptr || found->poisoned) {
      continue;
    }
    if (name.key->kind == EntityKind::element_set) {
      resolve_element_set(context, reference);
    } else {
      resolve_set_kind(context, name.key->kind, reference);
    }
  }
}

} // namespace spricka::deck
