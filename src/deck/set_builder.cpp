// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/set_builder.hpp"

#include "deck/sets.hpp"
#include "mesh/boundary.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

using grammar::Field;

/// Indices, each at most once, in the order they came.
class Collection {
public:
  explicit Collection(std::size_t count) : in_(count, false) {}

  void add(std::size_t i) {
    if (!in_[i]) {
      in_[i] = true;
      listed_.push_back(i);
    }
  }
  void remove(std::size_t i) { in_[i] = false; }

  std::vector<std::size_t> take() {
    std::vector<std::size_t> result;
    for (const std::size_t i : listed_) {
      if (in_[i]) {
        in_[i] = false; // once removed and added again, it is listed twice
        result.push_back(i);
      }
    }
    return result;
  }

private:
  std::vector<bool> in_;
  std::vector<std::size_t> listed_;
};

base::Vec3 centroid(const model::Mesh& mesh, base::ElementId e) {
  const auto nodes = mesh.nodes_of(e);
  const int corners = base::info(mesh.type[e.index()]).corners;
  base::Vec3 sum = base::Vec3::Zero();
  for (int i = 0; i < corners; ++i) {
    sum += mesh.x[nodes[static_cast<std::size_t>(i)].index()];
  }
  return sum / corners;
}

/// Lists the nodes or elements that the data lines of a card name.
class ItemReader {
public:
  ItemReader(Context& context, const BoundCard& card, Kind kind)
      : c_(context), card_(card), kind_(kind),
        labels_((kind == Kind::node_set ? context.node_labels
                                        : context.element_labels)[card.net_id.index()]) {}

  /// False if an item is not understood; the others are collected all the same.
  bool read(Collection& collection) {
    for (const grammar::Row& row : card_.rows) {
      for (const Field& field : row.fields) {
        if (field.separator == '=') {
          c_.error(field.span, "E115", "no '=' in a list of items",
                   std::string(card_.spec->data_form));
          ok_ = false;
        }
        item(field, collection);
      }
    }
    return ok_;
  }

private:
  void item(const Field& field, Collection& collection) {
    switch (field.kind) {
    case Field::Kind::number:
    case Field::Kind::expression:
      number(field, collection);
      break;
    case Field::Kind::range:
      range(field, collection);
      break;
    case Field::Kind::name:
    case Field::Kind::minus_name:
      members(field, collection);
      break;
    default:
      c_.error(field.span, "E115", "a number, a range or the name of a set is expected",
               std::string(card_.spec->data_form));
      ok_ = false;
    }
  }

  [[nodiscard]] std::string_view thing() const {
    return kind_ == Kind::node_set ? "node" : "element";
  }

  void number(const Field& field, Collection& collection) {
    const auto value = number_of(field, grammar::Quantity::number,
                                 fmt::format("a {} number", thing()), c_.scope, c_.diagnostics);
    if (!value) {
      ok_ = false;
      return;
    }
    const auto label = static_cast<base::Label>(*value);
    const auto found = static_cast<double>(label) == *value ? labels_.find(label) : std::nullopt;
    if (found) {
      collection.add(*found);
    } else {
      missing(field, fmt::format("there is no {} {}", thing(), *value));
    }
  }

  // Numbers in a range may be missing, as long as there is one.
  void range(const Field& field, Collection& collection) {
    const base::Label last = std::min(field.range[1], labels_.highest());
    bool any = false;
    for (base::Label label = field.range[0]; label <= last; label += field.range[2]) {
      if (const auto found = labels_.find(label)) {
        collection.add(*found);
        any = true;
      }
    }
    if (!any) {
      missing(field, fmt::format("there is no {} in this range", thing()));
    }
  }

  void missing(const Field& field, std::string text) {
    ok_ = false;
    if (labels_.complete) {
      c_.error(field.span, "E303",
               card_.net.empty() ? std::move(text) : text + " in net " + card_.net,
               card_.net.empty() && c_.model.nets.size() > 1
                   ? "numbers of a net are used between $NET and $ENDNET"
                   : "");
    }
  }

  void members(const Field& field, Collection& collection) {
    const Reference reference{field.text, field.span, card_.net};
    const bool minus = field.kind == Field::Kind::minus_name;
    const auto put = [&](std::size_t i) { minus ? collection.remove(i) : collection.add(i); };
    if (kind_ == Kind::node_set) {
      if (const auto id = use_node_set(c_, reference)) {
        for (const base::NodeId n : c_.model.mesh.set(*id).nodes) {
          put(n.index());
        }
        return;
      }
    } else if (const auto id = use_element_set(c_, reference)) {
      for (const base::ElementId e : c_.model.mesh.set(*id).elements) {
        put(e.index());
      }
      return;
    }
    ok_ = false;
  }

  Context& c_;
  const BoundCard& card_;
  Kind kind_;
  const Labels& labels_;
  bool ok_ = true;
};

bool has_positive_items(const BoundCard& card) {
  return std::any_of(card.rows.begin(), card.rows.end(), [](const grammar::Row& row) {
    return std::any_of(row.fields.begin(), row.fields.end(),
                       [](const Field& f) { return f.kind != Field::Kind::minus_name; });
  });
}

// A set by WHERE alone starts from everything: all nodes of its net, or of all nets outside nets.
bool starts_from_all(const BoundCard& card) {
  return !card.has("FROM") && !has_positive_items(card) && card.has("WHERE");
}

bool has_start(Context& c, const BoundCard& card) {
  if (card.has("FROM") || card.has("WHERE") || has_positive_items(card)) {
    return true;
  }
  c.error(card.span, "E115", fmt::format("${} needs items, FROM or WHERE", card.spec->name),
          std::string(card.spec->data_form));
  return false;
}

bool holds(const BoundCard& card, const base::Vec3& x) {
  return !card.has("WHERE") || card.find("WHERE")->expression(x) == 1.0;
}

// Sorts by ORDER, equal values by their place before.
bool sort_nodes(Context& c, const BoundCard& card, std::vector<std::size_t>& nodes) {
  if (!card.has("ORDER")) {
    return true;
  }
  std::vector<std::pair<double, std::size_t>> keyed;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    keyed.emplace_back(card.find("ORDER")->expression(c.model.mesh.x[nodes[i]]), nodes[i]);
    if (std::isnan(keyed.back().first)) {
      c.error(card.find("ORDER")->span, "E206",
              fmt::format("ORDER has no value at node {}", c.model.mesh.node_label[nodes[i]]));
      return false;
    }
  }
  std::stable_sort(keyed.begin(), keyed.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::transform(keyed.begin(), keyed.end(), nodes.begin(),
                 [](const auto& k) { return k.second; });
  return true;
}

std::optional<std::vector<base::NodeId>> nodes_of_card(Context& c, const BoundCard& card) {
  const model::Mesh& mesh = c.model.mesh;
  if (!has_start(c, card)) {
    return std::nullopt;
  }
  Collection collection(mesh.node_count());
  if (starts_from_all(card)) {
    for (std::size_t i = 0; i < mesh.node_count(); ++i) {
      if ((card.net.empty() || mesh.node_net[i] == card.net_id) && holds(card, mesh.x[i])) {
        collection.add(i);
      }
    }
  }
  bool ok = true;
  if (card.has("FROM")) {
    const auto from = use_node_set(c, card.reference("FROM"));
    ok = from.has_value();
    for (std::size_t i = 0; ok && i < mesh.set(*from).nodes.size(); ++i) {
      collection.add(mesh.set(*from).nodes[i].index());
    }
  }
  ok = ItemReader(c, card, Kind::node_set).read(collection) && ok;
  std::vector<std::size_t> indices = collection.take();
  std::erase_if(indices, [&](std::size_t i) { return !holds(card, mesh.x[i]); });
  if (!ok || !sort_nodes(c, card, indices)) {
    return std::nullopt;
  }
  return std::vector<base::NodeId>(indices.begin(), indices.end());
}

std::optional<std::vector<base::ElementId>> elements_of_card(Context& c, const BoundCard& card) {
  const model::Mesh& mesh = c.model.mesh;
  if (!has_start(c, card)) {
    return std::nullopt;
  }
  Collection collection(mesh.element_count());
  if (starts_from_all(card)) {
    for (std::size_t i = 0; i < mesh.element_count(); ++i) {
      if (card.net.empty() || mesh.element_net[i] == card.net_id) {
        collection.add(i);
      }
    }
  }
  bool ok = true;
  if (card.has("FROM")) {
    const auto from = use_element_set(c, card.reference("FROM"));
    ok = from.has_value();
    for (std::size_t i = 0; ok && i < mesh.set(*from).elements.size(); ++i) {
      collection.add(mesh.set(*from).elements[i].index());
    }
  }
  ok = ItemReader(c, card, Kind::element_set).read(collection) && ok;
  std::vector<std::size_t> indices = collection.take();
  std::erase_if(indices, [&](std::size_t i) {
    return !holds(card, centroid(mesh, base::ElementId(i)));
  });
  return ok ? std::optional(std::vector<base::ElementId>(indices.begin(), indices.end()))
            : std::nullopt;
}

const std::vector<model::Face>& boundary(Context& c) {
  if (!c.boundary) {
    c.boundary = mesh::boundary_faces(c.model.mesh);
  }
  return *c.boundary;
}

template <class Predicate>
bool all_nodes(const model::Mesh& mesh, const model::Face& face, const Predicate& predicate) {
  const auto nodes = mesh.nodes_of(face.element);
  const auto local = shape::side_nodes(mesh.type[face.element.index()], face.side);
  return std::all_of(local.begin(), local.end(),
                     [&](int i) { return predicate(nodes[static_cast<std::size_t>(i)]); });
}

// Faces of the sets that the data lines name, taken away by -SET.
bool face_items(Context& c, const BoundCard& card, std::vector<model::Face>& faces) {
  bool ok = true;
  for (const grammar::Row& row : card.rows) {
    for (const Field& field : row.fields) {
      if (field.kind != Field::Kind::name && field.kind != Field::Kind::minus_name) {
        c.error(field.span, "E115", "the name of a node or face set is expected",
                std::string(card.spec->data_form));
        ok = false;
        continue;
      }
      const auto id = use_face_set(c, {field.text, field.span, card.net});
      if (!id) {
        ok = false;
        continue;
      }
      for (const model::Face& face : c.model.mesh.set(*id).faces) {
        const auto it = std::find(faces.begin(), faces.end(), face);
        if (field.kind == Field::Kind::minus_name && it != faces.end()) {
          faces.erase(it);
        } else if (field.kind == Field::Kind::name && it == faces.end()) {
          faces.push_back(face);
        }
      }
    }
  }
  return ok;
}

std::optional<std::vector<model::Face>> faces_of_card(Context& c, const BoundCard& card) {
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
  } else if (card.has("FROM")) {
    const auto from = use_face_set(c, card.reference("FROM"));
    ok = from.has_value();
    if (ok) {
      faces = mesh.set(*from).faces;
    }
  }
  ok = face_items(c, card, faces) && ok;
  std::erase_if(faces, [&](const model::Face& face) {
    return !all_nodes(mesh, face,
                      [&](base::NodeId n) { return holds(card, mesh.x[n.index()]); });
  });
  return ok ? std::optional(std::move(faces)) : std::nullopt;
}

} // namespace

std::vector<model::Face> boundary_within(Context& context,
                                         const std::vector<base::NodeId>& nodes) {
  const model::Mesh& mesh = context.model.mesh;
  std::vector<bool> inside(mesh.node_count(), false);
  for (const base::NodeId n : nodes) {
    inside[n.index()] = true;
  }
  std::vector<model::Face> result;
  for (const model::Face& face : boundary(context)) {
    if (all_nodes(mesh, face, [&](base::NodeId n) { return inside[n.index()]; })) {
      result.push_back(face);
    }
  }
  return result;
}

void build_set(Context& context, const BoundCard& card) {
  const BoundValue& name = *card.find("NAME");
  const std::string full = qualify(card.net, name.text);
  const Kind kind = name.key->kind;
  model::Mesh& mesh = context.model.mesh;
  std::optional<std::size_t> size;
  std::size_t index = 0;
  const auto keep = [&](auto& sets, auto members) {
    if (members) {
      size = members->size();
      index = sets.size();
      sets.push_back({full, std::move(*members), card.span});
    }
  };
  if (kind == Kind::node_set) {
    keep(mesh.node_sets, nodes_of_card(context, card));
  } else if (kind == Kind::element_set) {
    keep(mesh.element_sets, elements_of_card(context, card));
  } else {
    keep(mesh.face_sets, faces_of_card(context, card));
  }
  if (size == std::size_t{0} && context.mesh_sound) {
    context.error(name.span, "E309", fmt::format("set {} is empty", full));
  }
  if (size.value_or(0) == 0) {
    context.names.poison(kind, full);
  }
  context.names.built(kind, full, index);
}

void build_sets(Context& context) {
  for (const BoundCard& card : context.cards) {
    if (card.bad || (card.spec->name != "NSET" && card.spec->name != "ESET" &&
                     card.spec->name != "FSET")) {
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

std::optional<std::vector<base::NodeId>> node_items(Context& context, const BoundCard& card) {
  Collection collection(context.model.mesh.node_count());
  if (!ItemReader(context, card, Kind::node_set).read(collection)) {
    return std::nullopt;
  }
  const std::vector<std::size_t> indices = collection.take();
  return std::vector<base::NodeId>(indices.begin(), indices.end());
}

} // namespace spricka::deck
