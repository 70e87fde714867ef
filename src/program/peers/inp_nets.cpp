// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/peers/inp_nets.hpp"

#include "base/disjoint_sets.hpp"
#include "mesh/set_name.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace spricka::program {
namespace {

constexpr std::size_t no_place = std::numeric_limits<std::size_t>::max();

template <class Set> const Set* find_set(const std::vector<Set>& sets, const std::string& written) {
  const std::string name = mesh::make_valid_set_name(written);
  const auto at = std::ranges::find_if(sets, [&](const Set& set) { return set.name == name; });
  return at == sets.end() ? nullptr : &*at;
}

} // namespace

InpNets::InpNets(const model::Model& model, std::string name) : model_(model) {
  find_bodies();
  if (!choose_sets()) {
    nets_.assign(1, {std::move(name), ""});
    net_.assign(bodies_, 0);
  }
  const model::Mesh& mesh = model.mesh;
  net_has_node_.assign(nets_.size(), std::vector<bool>(mesh.node_count(), false));
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (const base::NodeId n : mesh.element_nodes(base::ElementId(e))) {
      net_has_node_[net_[body_[e]]][n.index()] = true;
    }
  }
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    node_of_label_.emplace(mesh.node_label[n], base::NodeId(n));
  }
}

void InpNets::find_bodies() {
  const model::Mesh& mesh = model_.mesh;
  base::DisjointSets joined(mesh.node_count());
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.element_nodes(base::ElementId(e));
    for (const base::NodeId n : nodes) {
      joined.join_sets(nodes[0].index(), n.index());
    }
  }
  std::vector<std::size_t> body_of_root(mesh.node_count(), no_place);
  body_.resize(mesh.element_count());
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    std::size_t& body =
        body_of_root[joined.root(mesh.element_nodes(base::ElementId(e))[0].index())];
    body = body == no_place ? bodies_++ : body;
    body_[e] = body;
  }
}

bool InpNets::choose_sets() {
  const std::vector<model::ElementSet>& sets = model_.mesh.element_sets;
  std::vector<std::size_t> size(bodies_, 0);
  for (const std::size_t body : body_) {
    ++size[body];
  }
  std::vector<std::size_t> chosen(bodies_, no_place); ///< [body] a set
  for (std::size_t s = 0; s < sets.size(); ++s) {
    std::vector<std::size_t> held(bodies_, 0);
    for (const base::ElementId e : sets[s].elements) {
      ++held[body_[e.index()]];
    }
    bool whole = bodies_ > 1;
    for (std::size_t b = 0; b < bodies_; ++b) {
      whole = whole && (held[b] == 0 || held[b] == size[b]);
    }
    for (std::size_t b = 0; whole && b < bodies_; ++b) {
      if (held[b] > 0 &&
          (chosen[b] == no_place || sets[s].elements.size() < sets[chosen[b]].elements.size())) {
        chosen[b] = s;
      }
    }
  }
  net_.assign(bodies_, no_place);
  std::vector<std::size_t> net_of_set(sets.size(), no_place);
  std::size_t elements = 0;
  for (std::size_t b = 0; b < bodies_; ++b) {
    if (chosen[b] == no_place) {
      return false;
    }
    std::size_t& net = net_of_set[chosen[b]];
    if (net == no_place) {
      net = nets_.size();
      nets_.push_back({sets[chosen[b]].name, sets[chosen[b]].name});
      elements += sets[chosen[b]].elements.size();
    }
    net_[b] = net;
  }
  const bool divided = elements == body_.size() && nets_.size() > 1; // no set has a body of another
  if (!divided) {
    nets_.clear();
  }
  return divided;
}

std::vector<std::string> InpNets::in_nets(const std::string& set,
                                          const std::vector<bool>& member) const {
  std::vector<std::string> names;
  for (std::size_t net = 0; net < nets_.size(); ++net) {
    if (member[net]) {
      names.push_back(nets_[net].name + "." + set);
    }
  }
  return names;
}

std::vector<std::string> InpNets::node_set(const std::string& written) const {
  const model::NodeSet* set = find_set(model_.mesh.node_sets, written);
  std::vector<bool> member(nets_.size(), false);
  for (std::size_t net = 0; set != nullptr && net < nets_.size(); ++net) {
    member[net] = std::ranges::any_of(
        set->nodes, [&](base::NodeId n) { return net_has_node_[net][n.index()]; });
  }
  return set == nullptr ? std::vector<std::string>() : in_nets(set->name, member);
}

std::vector<std::string> InpNets::face_set(const std::string& written) const {
  const model::FaceSet* set = find_set(model_.mesh.face_sets, written);
  std::vector<bool> member(nets_.size(), false);
  for (std::size_t f = 0; set != nullptr && f < set->faces.size(); ++f) {
    member[net_of(set->faces[f].element)] = true;
  }
  return set == nullptr ? std::vector<std::string>() : in_nets(set->name, member);
}

std::vector<std::string> InpNets::element_set(const std::string& written) const {
  const model::ElementSet* set = find_set(model_.mesh.element_sets, written);
  std::vector<bool> member(nets_.size(), false);
  for (std::size_t i = 0; set != nullptr && i < set->elements.size(); ++i) {
    member[net_of(set->elements[i])] = true;
  }
  return set == nullptr ? std::vector<std::string>() : in_nets(set->name, member);
}

std::optional<std::size_t> InpNets::net_of_node(base::Label label) const {
  const auto at = node_of_label_.find(label);
  for (std::size_t net = 0; at != node_of_label_.end() && net < nets_.size(); ++net) {
    if (net_has_node_[net][at->second.index()]) {
      return net;
    }
  }
  return std::nullopt;
}

} // namespace spricka::program
