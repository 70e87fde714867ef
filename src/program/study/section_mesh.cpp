// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/section_mesh.hpp"

#include "base/element_type.hpp"
#include "grammar/lexeme.hpp"
#include "mesh/boundary.hpp"
#include "model/model.hpp"
#include "program/study/deck_edits.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace spricka::program {

namespace {

using deck::DeckCard;
using deck::DeckCardList;

/// Labels of nodes or elements as texts, by the net that has them, upper case.
using LabelsByNet = std::map<std::string, std::vector<std::string>>;

std::string local_name(const std::string& name) {
  const std::size_t point = name.find('.');
  return point == std::string::npos ? name : name.substr(point + 1);
}

// Ten items to a line.
DeckCard set_card(const char* kind, const std::string& name,
                  const std::vector<std::string>& items) {
  constexpr std::size_t wide = 10;
  std::string data;
  for (std::size_t i = 0; i < items.size(); ++i) {
    data += (i % wide == 0 ? "  " : " ") + items[i];
    data += i % wide == wide - 1 || i + 1 == items.size() ? "\n" : "";
  }
  return deck::make_card(kind, {{"NAME", name}}, data);
}

class MeshCards {
public:
  MeshCards(const model::Model& model, const model::Mesh& mesh) : model_(model), mesh_(mesh) {
    for (std::size_t n = 0; n < model.nets.size(); ++n) {
      add_mesh(base::NetId(n));
    }
    for (const model::NodeSet& set : mesh.node_sets) {
      add_set("NSET", set.name, node_labels(set.nodes));
    }
    for (const model::ElementSet& set : mesh.element_sets) {
      add_set("ESET", set.name, labels_of(set.elements, mesh.element_net, mesh.element_label));
    }
    for (const model::FaceSet& set : mesh.face_sets) {
      add_face_set(set);
    }
  }

  DeckCardList with(const DeckCardList& cards) && {
    for (const DeckCard& card : cards) {
      nets_[card.net].push_back(card);
    }
    DeckCardList all;
    for (const model::MeshNet& net : model_.nets) {
      if (const std::string name = grammar::to_upper(net.name); !name.empty()) {
        all.push_back(deck::make_card("NET", {{"NAME", name}}));
        std::ranges::move(nets_[name], std::back_inserter(all));
        all.push_back(deck::make_card("ENDNET"));
      }
    }
    std::ranges::move(nets_[""], std::back_inserter(all));
    return all;
  }

private:
  [[nodiscard]] std::string net_name(base::NetId net) const {
    return grammar::to_upper(model_.nets[net.index()].name);
  }

  void add_mesh(base::NetId net) {
    DeckCard nodes = deck::make_card("COOR", {{"DIM", "2"}});
    for (std::size_t n = 0; n < mesh_.node_count(); ++n) {
      if (mesh_.node_net[n] == net) {
        nodes.data +=
            fmt::format("  {}  {}  {}\n", mesh_.node_label[n], mesh_.x[n].x(), mesh_.x[n].y());
      }
    }
    if (nodes.data.empty()) {
      return;
    }
    std::map<base::ElementType, std::string> elements;
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      if (mesh_.element_net[e] == net) {
        std::vector<base::Label> labels;
        for (const base::NodeId n : mesh_.element_nodes(base::ElementId(e))) {
          labels.push_back(mesh_.node_label[n.index()]);
        }
        elements[mesh_.type[e]] +=
            fmt::format("  {}  {}\n", mesh_.element_label[e], fmt::join(labels, " "));
      }
    }
    DeckCardList& cards = nets_[net_name(net)];
    cards.push_back(std::move(nodes));
    for (auto& [type, lines] : elements) {
      cards.push_back(deck::make_card(
          "ELEMENT", {{"TYPE", std::string(base::element_info(type).name)}}, std::move(lines)));
    }
  }

  template <class Ids>
  [[nodiscard]] LabelsByNet labels_of(const Ids& ids, const std::vector<base::NetId>& nets,
                                      const std::vector<base::Label>& labels) const {
    LabelsByNet found;
    for (const auto id : ids) {
      found[net_name(nets[id.index()])].push_back(fmt::format("{}", labels[id.index()]));
    }
    return found;
  }
  [[nodiscard]] LabelsByNet node_labels(const std::vector<base::NodeId>& nodes) const {
    return labels_of(nodes, mesh_.node_net, mesh_.node_label);
  }

  void add_set(const char* kind, const std::string& name, const LabelsByNet& labels) {
    if (name.empty() || labels.empty()) {
      return;
    }
    const std::string local = local_name(name);
    const bool own = labels.size() == 1 && labels.begin()->first == net_prefix(name);
    const DeckCard set = set_card(
        kind, local, own ? labels.begin()->second : add_parts(kind, local + "_PART", labels));
    nets_[net_prefix(name)].push_back(set);
  }

  // Names of sets in each of the nets.
  std::vector<std::string> add_parts(const char* kind, const std::string& wanted,
                                     const LabelsByNet& labels) {
    const std::string name = unused_set_name(mesh_, wanted);
    std::vector<std::string> names;
    for (const auto& [net, numbers] : labels) {
      names.push_back(net.empty() ? name : net + "." + name);
      nets_[net].push_back(set_card(kind, name, numbers));
    }
    return names;
  }

  // By their nodes.
  void add_face_set(const model::FaceSet& set) {
    if (set.name.empty() || set.faces.empty()) {
      return;
    }
    const std::string local = local_name(set.name);
    const std::string net = net_prefix(set.name);
    std::vector<std::string> items =
        add_parts("NSET", local + "_NODES", node_labels(mesh::nodes_of_faces(mesh_, set.faces)));
    if (!net.empty()) {
      std::ranges::transform(items, items.begin(), local_name);
    }
    nets_[net].push_back(set_card("FSET", local, items));
  }

  const model::Model& model_;
  const model::Mesh& mesh_;
  std::map<std::string, DeckCardList> nets_; ///< by name, upper case; what stands in none by ""
};

} // namespace

std::string unused_set_name(const model::Mesh& mesh, std::string wanted) {
  const auto taken = [&](const auto& sets) {
    return std::ranges::any_of(sets,
                               [&](const auto& set) { return local_name(set.name) == wanted; });
  };
  while (taken(mesh.node_sets) || taken(mesh.element_sets) || taken(mesh.face_sets)) {
    wanted += "_";
  }
  return wanted;
}

DeckCardList write_mesh_cards(const model::Model& model, const model::Mesh& mesh,
                              const DeckCardList& cards) {
  return MeshCards(model, mesh).with(cards);
}

} // namespace spricka::program
