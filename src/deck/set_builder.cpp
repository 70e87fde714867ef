// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/set_builder.hpp"

#include "deck/items.hpp"
#include "geometry/box.hpp"
#include "mesh/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

using grammar::CardField;

base::Vec3 centroid(const model::Mesh& mesh, base::ElementId e) {
  const auto nodes = mesh.element_nodes(e);
  const int corners = base::element_info(mesh.type[e.index()]).corners;
  base::Vec3 sum = base::Vec3::Zero();
  for (int i = 0; i < corners; ++i) {
    sum += mesh.x[nodes[static_cast<std::size_t>(i)].index()];
  }
  return sum / corners;
}

bool has_positive_items(const CheckedCard& card) {
  return std::ranges::any_of(card.rows, [](const grammar::DataRow& row) {
    return std::ranges::any_of(row.fields, [](const CardField& f) {
      return f.kind != CardField::CardFieldKind::minus_name;
    });
  });
}

// A set by WHERE alone starts from everything: all nodes of its net, or of all nets outside nets.
bool starts_from_all(const CheckedCard& card) {
  return !card.has_key("FROM") && !has_positive_items(card) && card.has_key("WHERE");
}

bool has_start(DeckContext& c, const CheckedCard& card) {
  if (card.has_key("FROM") || card.has_key("WHERE") || has_positive_items(card) || card.rows_bad) {
    return true;
  }
  c.error(card.span, "E115", fmt::format("${} needs items, FROM or WHERE", card.spec->name),
          std::string(card.spec->data_form));
  return false;
}

bool holds(const CheckedCard& card, const base::Vec3& x) {
  return !card.has_key("WHERE") || card.find("WHERE")->expression(x) == 1.0;
}

// Sorts by ORDER, equal values by their place before.
bool sort_nodes(DeckContext& c, const CheckedCard& card, std::vector<std::size_t>& nodes) {
  if (!card.has_key("ORDER")) {
    return true;
  }
  std::vector<std::pair<double, std::size_t>> keyed;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    keyed.emplace_back(card.find("ORDER")->expression(c.model.mesh.x[nodes[i]]), nodes[i]);
    if (!std::isfinite(keyed.back().first)) {
      c.error(card.find("ORDER")->span, "E206",
              fmt::format("ORDER has no value at node {}", c.model.mesh.node_label[nodes[i]]));
      return false;
    }
  }
  std::ranges::stable_sort(keyed, [](const auto& a, const auto& b) { return a.first < b.first; });
  std::transform(keyed.begin(), keyed.end(), nodes.begin(), [](const auto& k) { return k.second; });
  return true;
}

// The nodes or elements of a card, in their order; a member is asked for WHERE by its place(i).
// `from`: the members of the set that the card takes its own from.
template <class Members, class Place>
std::optional<std::vector<std::size_t>>
collected(DeckContext& c, const CheckedCard& card, EntityKind kind, const SetFinder& sets,
          const std::vector<base::NetId>& nets, Members&& from, Place&& place) {
  if (!has_start(c, card)) {
    return std::nullopt;
  }
  OrderedIndexSet collection(nets.size());
  for (std::size_t i = 0; i < nets.size() && starts_from_all(card); ++i) {
    if (card.net.empty() || nets[i] == card.net_id) {
      collection.add(i);
    }
  }
  bool ok = true;
  if (card.has_key("FROM")) {
    const auto* members = from(card.name_reference("FROM"));
    ok = members != nullptr;
    for (std::size_t i = 0; ok && i < members->size(); ++i) {
      collection.add((*members)[i].index());
    }
  }
  ok = read_listed_members(c, card, kind, sets, collection) && ok;
  std::vector<std::size_t> indices = collection.collected_indices();
  std::erase_if(indices, [&](std::size_t i) { return !holds(card, place(i)); });
  return ok ? std::optional(std::move(indices)) : std::nullopt;
}

std::optional<std::vector<base::NodeId>> nodes_of_card(DeckContext& c, const CheckedCard& card,
                                                       const SetFinder& sets) {
  const model::Mesh& mesh = c.model.mesh;
  const auto from = [&](const NameReference& reference) {
    const auto set = sets.nodes(reference);
    return set ? &mesh.set_with_id(*set).nodes : nullptr;
  };
  auto indices = collected(c, card, EntityKind::node_set, sets, mesh.node_net, from,
                           [&](std::size_t i) { return mesh.x[i]; });
  if (!indices || !sort_nodes(c, card, *indices)) {
    return std::nullopt;
  }
  return std::vector<base::NodeId>(indices->begin(), indices->end());
}

std::optional<std::vector<base::ElementId>>
elements_of_card(DeckContext& c, const CheckedCard& card, const SetFinder& sets) {
  const model::Mesh& mesh = c.model.mesh;
  const auto from = [&](const NameReference& reference) {
    const auto set = sets.elements(reference);
    return set ? &mesh.set_with_id(*set).elements : nullptr;
  };
  const auto indices = collected(c, card, EntityKind::element_set, sets, mesh.element_net, from,
                                 [&](std::size_t i) { return centroid(mesh, base::ElementId(i)); });
  return indices ? std::optional(std::vector<base::ElementId>(indices->begin(), indices->end()))
                 : std::nullopt;
}

const std::vector<model::Face>& boundary(DeckContext& c) {
  if (!c.boundary) {
    c.boundary = mesh::boundary_faces(c.model.mesh);
  }
  return *c.boundary;
}

std::uint64_t number_of_face(const model::Face& face) {
  return 8 * static_cast<std::uint64_t>(face.element.value) + static_cast<std::uint64_t>(face.side);
}

// Faces of the sets that the data lines name, taken away by -SET.
bool face_items(DeckContext& c, const CheckedCard& card, const SetFinder& sets,
                std::vector<model::Face>& faces) {
  bool ok = true;
  std::unordered_set<std::uint64_t> present;
  for (const model::Face& face : faces) {
    present.insert(number_of_face(face));
  }
  for (const grammar::DataRow& row : card.rows) {
    for (const CardField& field : row.fields) {
      if (!field.is_name() && field.kind != CardField::CardFieldKind::minus_name) {
        c.error(field.span, "E115", "the name of a node or face set is expected",
                std::string(card.spec->data_form));
        ok = false;
        continue;
      }
      const auto id = sets.faces({field.text, field.span, card.net});
      if (!id) {
        ok = false;
        continue;
      }
      const bool minus = field.kind == CardField::CardFieldKind::minus_name;
      for (const model::Face& face : c.model.mesh.set_with_id(*id).faces) {
        if (minus) {
          present.erase(number_of_face(face));
        } else if (present.insert(number_of_face(face)).second) {
          faces.push_back(face);
        }
      }
      if (minus) {
        std::erase_if(faces, [&](const model::Face& face) {
          return !present.contains(number_of_face(face));
        });
      }
    }
  }
  return ok;
}

std::optional<std::vector<model::Face>> faces_of_card(DeckContext& c, const CheckedCard& card,
                                                      const SetFinder& sets) {
  const model::Mesh& mesh = c.model.mesh;
  if (!has_start(c, card)) {
    return std::nullopt;
  }
  std::vector<model::Face> faces;
  bool ok = true;
  if (starts_from_all(card)) {
    for (const model::Face& face : boundary(c)) {
      if (card.net.empty() || mesh.element_net[face.element.index()] == card.net_id) {
        faces.push_back(face);
      }
    }
  } else if (card.has_key("FROM")) {
    const auto from = sets.faces(card.name_reference("FROM"));
    ok = from.has_value();
    if (ok) {
      faces = mesh.set_with_id(*from).faces;
    }
  }
  ok = face_items(c, card, sets, faces) && ok;
  if (card.has_key("WHERE")) {
    std::vector<bool> inside(mesh.node_count(), false);
    for (const base::NodeId n : mesh::nodes_of_faces(mesh, faces)) {
      inside[n.index()] = holds(card, mesh.x[n.index()]);
    }
    const auto others =
        std::stable_partition(faces.begin(), faces.end(), [&](const model::Face& face) {
          return mesh::face_has_all_nodes_inside(mesh, face, inside);
        });
    const std::vector<model::Face> left_out(others, faces.end());
    faces.erase(others, faces.end());
    const FaceSetConditionAreas border = face_set_condition_areas(
        mesh, faces, left_out, [&](const base::Vec3& x) { return holds(card, x); });
    constexpr double little = 0.01;
    if (border.meant > (1.0 + little) * border.taken) {
      c.set_borders[mesh.face_sets.size()] = border;
    }
  }
  return ok ? std::optional(std::move(faces)) : std::nullopt;
}

// Where the nodes lie that WHERE chose none of.
std::string extent(const DeckContext& c, const CheckedCard& card) {
  const model::Mesh& mesh = c.model.mesh;
  geometry::Box<3> box;
  for (std::size_t i = 0; i < mesh.node_count(); ++i) {
    if (card.net.empty() || mesh.node_net[i] == card.net_id) {
      box.extend({mesh.x[i], mesh.x[i]});
    }
  }
  if (box.low.x() > box.high.x()) {
    return "there are no nodes";
  }
  std::vector<std::string> ranges;
  ranges.reserve(3);
  for (int i = 0; i < mesh.dim; ++i) {
    ranges.push_back(fmt::format("{} = {:.6g} .. {:.6g}", "xyz"[i], box.low[i], box.high[i]));
  }
  return fmt::format("WHERE holds nowhere: nodes have {}", fmt::join(ranges, ", "));
}

} // namespace

std::vector<model::Face> cached_boundary_faces_within(DeckContext& context,
                                                      const std::vector<base::NodeId>& nodes) {
  const model::Mesh& mesh = context.model.mesh;
  const std::vector<bool> inside = model::mark_members(mesh.node_count(), nodes);
  std::vector<model::Face> result;
  for (const model::Face& face : boundary(context)) {
    if (mesh::face_has_all_nodes_inside(mesh, face, inside)) {
      result.push_back(face);
    }
  }
  return result;
}

void build_set(DeckContext& context, const CheckedCard& card, const SetFinder& sets) {
  const CheckedValue& name = *card.find("NAME");
  const std::string full = qualified_name(card.net, name.text);
  const EntityKind kind = name.key->kind;
  model::Mesh& mesh = context.model.mesh;
  std::optional<std::size_t> size;
  std::size_t index = 0;
  const auto keep = [&](auto& into, auto members) {
    if (members) {
      size = members->size();
      index = into.size();
      into.push_back({full, std::move(*members), card.span});
    }
  };
  if (kind == EntityKind::node_set) {
    keep(mesh.node_sets, nodes_of_card(context, card, sets));
  } else if (kind == EntityKind::element_set) {
    keep(mesh.element_sets, elements_of_card(context, card, sets));
  } else {
    keep(mesh.face_sets, faces_of_card(context, card, sets));
  }
  // where a mesh is missing, as one in space may, an empty set says nothing
  const bool whole = std::ranges::all_of(context.node_labels,
                                         [](const LabelMap& labels) { return labels.complete; });
  if (size == std::size_t{0} && context.mesh_sound && whole && !card.rows_bad) {
    context.error(name.span, "E309", fmt::format("set {} is empty", full),
                  card.has_key("WHERE") ? extent(context, card) : "");
  }
  if (size.value_or(0) == 0 || card.rows_bad) {
    context.names.poison(kind, full);
  }
  context.names.mark_set_built(kind, full, index);
}

} // namespace spricka::deck
