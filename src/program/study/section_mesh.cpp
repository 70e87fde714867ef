// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/section_mesh.hpp"

#include "base/element_type.hpp"
#include "grammar/lexeme.hpp"
#include "mesh/boundary.hpp"
#include "model/model.hpp"
#include "program/study/deck_edits.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace spricka::program {

namespace {

using deck::DeckCard;
using deck::DeckText;

std::string local_name(const std::string& name) {
  const std::size_t point = name.find('.');
  return point == std::string::npos ? name : name.substr(point + 1);
}

// Ten to a line.
std::string items_of(const std::vector<std::string>& items) {
  std::string data;
  constexpr std::size_t wide = 10;
  for (std::size_t i = 0; i < items.size(); ++i) {
    data += i % wide == 0 ? "  " : " ";
    data += items[i];
    data += i % wide == wide - 1 || i + 1 == items.size() ? "\n" : "";
  }
  return data;
}

DeckCard set_card(const char* kind, const std::string& name,
                  const std::vector<std::string>& items) {
  return deck::make_card(kind, {{"NAME", name}}, items_of(items));
}

} // namespace

MeshCards::MeshCards(const model::Model& model, const model::Mesh& mesh)
    : model_(model), mesh_(mesh), nets_(model.nets.size()) {
  for (std::size_t n = 0; n < model.nets.size(); ++n) {
    add_mesh(base::NetId(n));
  }
  add_sets();
}

void MeshCards::add_card(const DeckCard& card) {
  put(card.net, card);
}

void MeshCards::put(const std::string& net, DeckCard card) {
  for (std::size_t n = 0; n < nets_.size(); ++n) {
    if (net_name(base::NetId(n)) == net) {
      nets_[n].push_back(std::move(card));
      return;
    }
  }
}

void MeshCards::add_mesh(base::NetId net) {
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
  DeckText cards{std::move(nodes)};
  for (const base::ElementInfo& info : base::element_infos) {
    DeckCard elements = deck::make_card("ELEMENT", {{"TYPE", std::string(info.name)}});
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      if (mesh_.element_net[e] == net && base::element_info(mesh_.type[e]).name == info.name) {
        std::vector<base::Label> labels;
        for (const base::NodeId n : mesh_.element_nodes(base::ElementId(e))) {
          labels.push_back(mesh_.node_label[n.index()]);
        }
        elements.data += fmt::format("  {}  {}\n", mesh_.element_label[e], fmt::join(labels, " "));
      }
    }
    if (!elements.data.empty()) {
      cards.push_back(std::move(elements));
    }
  }
  nets_[net.index()] = std::move(cards);
}

std::string MeshCards::new_name(const std::string& request) {
  std::string name = request;
  const auto taken = [&](const auto& sets) {
    return std::ranges::any_of(sets, [&](const auto& set) { return local_name(set.name) == name; });
  };
  while (taken(mesh_.node_sets) || taken(mesh_.element_sets) || taken(mesh_.face_sets)) {
    name += "_";
  }
  return name;
}

std::vector<std::string> MeshCards::parts(const char* kind, const std::string& name,
                                          const LabelsByNet& labels) {
  std::vector<std::string> names;
  for (const auto& [net, numbers] : labels) {
    names.push_back(net.empty() ? name : net + "." + name);
    put(net, set_card(kind, name, numbers));
  }
  return names;
}

void MeshCards::named_set(const char* kind, const std::string& name, const LabelsByNet& labels) {
  if (name.empty() || labels.empty()) {
    return;
  }
  const std::string local = local_name(name);
  const bool own = labels.size() == 1 && labels.begin()->first == net_prefix(name);
  put(net_prefix(name),
      set_card(kind, local,
               own ? labels.begin()->second : parts(kind, new_name(local + "_PART"), labels)));
}

std::string MeshCards::net_name(base::NetId net) const {
  return grammar::to_upper(model_.nets[net.index()].name);
}

MeshCards::LabelsByNet MeshCards::labels_of(const std::vector<base::NodeId>& nodes) const {
  LabelsByNet labels;
  for (const base::NodeId n : nodes) {
    labels[net_name(mesh_.node_net[n.index()])].push_back(
        fmt::format("{}", mesh_.node_label[n.index()]));
  }
  return labels;
}

std::vector<std::string> MeshCards::add_node_set(const std::string& name,
                                                 const std::vector<base::NodeId>& nodes) {
  return parts("NSET", new_name(name), labels_of(nodes));
}

void MeshCards::add_sets() {
  for (const model::NodeSet& set : mesh_.node_sets) {
    named_set("NSET", set.name, labels_of(set.nodes));
  }
  for (const model::ElementSet& set : mesh_.element_sets) {
    LabelsByNet labels;
    for (const base::ElementId e : set.elements) {
      labels[net_name(mesh_.element_net[e.index()])].push_back(
          fmt::format("{}", mesh_.element_label[e.index()]));
    }
    named_set("ESET", set.name, labels);
  }
  for (const model::FaceSet& set : mesh_.face_sets) {
    if (!set.name.empty() && !set.faces.empty()) {
      add_face_set(set);
    }
  }
}

void MeshCards::add_face_set(const model::FaceSet& set) {
  const std::string local = local_name(set.name);
  const bool inside = !net_prefix(set.name).empty();
  std::vector<std::string> items;
  for (const std::string& part :
       add_node_set(local + "_NODES", mesh::nodes_of_faces(mesh_, set.faces))) {
    items.push_back(inside ? local_name(part) : part);
  }
  put(net_prefix(set.name), set_card("FSET", local, items));
}

DeckText MeshCards::text() const {
  DeckText all;
  DeckText outside;
  for (std::size_t n = 0; n < nets_.size(); ++n) {
    const std::string name = net_name(base::NetId(n));
    if (name.empty()) {
      outside.insert(outside.end(), nets_[n].begin(), nets_[n].end());
      continue;
    }
    all.push_back(deck::make_card("NET", {{"NAME", name}}));
    all.insert(all.end(), nets_[n].begin(), nets_[n].end());
    all.push_back(deck::make_card("ENDNET"));
  }
  all.insert(all.end(), outside.begin(), outside.end());
  return all;
}

} // namespace spricka::program
