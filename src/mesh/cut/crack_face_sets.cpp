// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/crack_face_sets.hpp"

#include "mesh/cut/host.hpp"

#include <algorithm>
#include <set>

namespace spricka::mesh {
namespace {

using base::NodeId;
using Ends = std::pair<NodeId, NodeId>;

// Whether both faces are meshed; a half has one and doubles no node.
bool is_open(const CrackFaceNodes& crack_faces) {
  return !crack_faces.left.empty() && crack_faces.left.size() == crack_faces.right.size();
}

std::vector<bool> corners_of(const model::Mesh& mesh) {
  std::vector<bool> corner(mesh.node_count(), false);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.element_nodes(base::ElementId(e));
    for (int i = 0; i < base::element_info(mesh.type[e]).corners; ++i) {
      corner[nodes[static_cast<std::size_t>(i)].index()] = true;
    }
  }
  return corner;
}

} // namespace

NodeSetsOnCrackFaces::NodeSetsOnCrackFaces(const model::Mesh& mesh,
                                           std::span<const CrackFaceNodes> crack_faces)
    : group_of_(mesh.node_count(), -1) {
  for (const CrackFaceNodes& crack_face : crack_faces) {
    for (const auto& [left, right] : crack_face.coincident_node_pairs()) {
      add_group(left, right);
    }
  }
  // Where the cut has told sides, in space, it knows which face a set means.
  if (groups_.empty() || std::ranges::any_of(crack_faces, &CrackFaceNodes::has_sides)) {
    return;
  }
  corner_ = corners_of(mesh);
  for (const CrackFaceNodes& crack_face : crack_faces) {
    if (is_open(crack_face)) {
      add_neighbours(crack_face.left);
      add_neighbours(crack_face.right);
    }
  }
  find_sides(mesh, crack_faces);
}

void NodeSetsOnCrackFaces::add_group(NodeId left, NodeId right) {
  std::int32_t& group = group_of_[left.index()];
  if (group < 0) {
    group = static_cast<std::int32_t>(groups_.size());
    groups_.push_back({left});
  }
  // Where several cracks double one node its place has more than two.
  groups_[static_cast<std::size_t>(group)].push_back(right);
  group_of_[right.index()] = group;
}

void NodeSetsOnCrackFaces::add_neighbours(const std::vector<NodeId>& crack_face) {
  for (std::size_t i = 1; i + 1 < crack_face.size(); ++i) {
    // A side is told by its corners: middle nodes go with the corners before and behind them.
    if (!corner_[crack_face[i].index()]) {
      beside_.emplace_back(crack_face[i], crack_face[i - 1]);
      beside_.emplace_back(crack_face[i], crack_face[i + 1]);
    }
  }
}

void NodeSetsOnCrackFaces::find_sides(const model::Mesh& mesh,
                                      std::span<const CrackFaceNodes> crack_faces) {
  std::set<Ends> along;
  for (const CrackFaceNodes& crack_face : crack_faces) {
    for (const std::vector<NodeId>* face : {&crack_face.left, &crack_face.right}) {
      NodeId last;
      for (const NodeId n : *face) {
        if (is_open(crack_face) && corner_[n.index()]) {
          if (last.valid()) {
            along.insert(std::minmax(last, n));
          }
          last = n;
        }
      }
    }
  }
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const base::ElementId element(e);
    if (std::ranges::none_of(mesh.element_nodes(element),
                             [&](NodeId n) { return group_of_[n.index()] >= 0; })) {
      continue;
    }
    for (int s = 0; s < base::element_info(mesh.type[e]).sides; ++s) {
      const EdgeEndAndMidNodes edge = element_edge_nodes(mesh, {element, s});
      if (group_of_[edge.a.index()] >= 0 || group_of_[edge.b.index()] >= 0) {
        sides_.push_back({edge.a, edge.b, along.contains(std::minmax(edge.a, edge.b))});
      }
    }
  }
}

std::vector<NodeSetsOnCrackFaces::ChosenCoincidentNodes>
NodeSetsOnCrackFaces::choose_nodes_belonging_to_set(const std::vector<NodeId>& members) const {
  std::vector<bool> touched(groups_.size(), false);
  bool any = false;
  for (const NodeId n : members) {
    if (n.index() < group_of_.size() && group_of_[n.index()] >= 0) {
      touched[static_cast<std::size_t>(group_of_[n.index()])] = true;
      any = true;
    }
  }
  std::vector<ChosenCoincidentNodes> result;
  if (!any) {
    return result;
  }
  std::vector<bool> in = model::mark_members(group_of_.size(), members);
  // At first all nodes of a place that the set touches stand in for its member: which of them are
  // meant is told by their sides.
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    for (const NodeId n : touched[g] ? groups_[g] : std::vector<NodeId>()) {
      in[n.index()] = true;
    }
  }
  std::vector<bool> beside(group_of_.size(), false); // a side of the set leads away from the crack
  std::vector<bool> line(group_of_.size(), false);   // one goes along it
  for (const SideTouchingCrack& side : sides_) {
    if (in[side.a.index()] && in[side.b.index()]) {
      std::vector<bool>& mark = side.along ? line : beside;
      mark[side.a.index()] = mark[side.b.index()] = true;
    }
  }
  for (const auto& [middle, corner] : beside_) {
    beside[middle.index()] = beside[middle.index()] || beside[corner.index()];
    line[middle.index()] = line[middle.index()] || in[corner.index()];
  }
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    if (!touched[g]) {
      continue;
    }
    ChosenCoincidentNodes choice{groups_[g], {}, false};
    std::ranges::copy_if(groups_[g], std::back_inserter(choice.chosen),
                         [&](NodeId n) { return beside[n.index()]; });
    if (choice.chosen.empty()) {
      choice.chosen = groups_[g];
      choice.alone = std::ranges::none_of(groups_[g], [&](NodeId n) { return line[n.index()]; });
    }
    result.push_back(std::move(choice));
  }
  return result;
}

std::span<const NodeId> NodeSetsOnCrackFaces::coincident_nodes(NodeId node) const {
  const bool doubled = node.index() < group_of_.size() && group_of_[node.index()] >= 0;
  return doubled
             ? std::span<const NodeId>(groups_[static_cast<std::size_t>(group_of_[node.index()])])
             : std::span<const NodeId>();
}

void add_crack_face_nodes(model::Mesh& mesh, std::span<const CrackFaceNodes> crack_faces) {
  const NodeSetsOnCrackFaces membership(mesh, crack_faces);
  for (model::NodeSet& set : mesh.node_sets) {
    std::vector<NodeId> late;
    for (const NodeSetsOnCrackFaces::ChosenCoincidentNodes& choice :
         membership.choose_nodes_belonging_to_set(set.nodes)) {
      // the set keeps its order: the first that is chosen stands where the host's node stood
      std::ranges::replace(set.nodes, choice.nodes.front(), choice.chosen.front());
      late.insert(late.end(), choice.chosen.begin() + 1, choice.chosen.end());
    }
    set.nodes.insert(set.nodes.end(), late.begin(), late.end());
  }
}

} // namespace spricka::mesh
