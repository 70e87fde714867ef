// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/patch_net.hpp"

#include "mesh/plane.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <numeric>

#include <Eigen/Geometry>

namespace spricka::mesh {

using base::NodeId;
using base::Vec3;

int PatchMeshBuilder::find_or_add_host_node(NodeId n) {
  const auto [at, fresh] = of_host_.try_emplace(n.value, static_cast<int>(nodes.size()));
  if (fresh) {
    nodes.push_back({host_.x[n.index()], frame_.rounded_local_coordinates(host_.x[n.index()]), n});
  }
  return at->second;
}

int PatchMeshBuilder::add_node_at_position(const Vec3& x) {
  nodes.push_back({x, frame_.rounded_local_coordinates(x), {}});
  return static_cast<int>(nodes.size()) - 1;
}

int PatchMeshBuilder::add_node_at_local_position(const Vec3& place) {
  nodes.push_back({frame_.global(place), rounded(place), {}});
  return static_cast<int>(nodes.size()) - 1;
}

int PatchMeshBuilder::duplicate_node(int n) {
  PatchNode node = nodes[static_cast<std::size_t>(n)];
  node.host = {};
  nodes.push_back(node);
  return static_cast<int>(nodes.size()) - 1;
}

std::optional<int> PatchMeshBuilder::find_mid_node(int a, int b) const {
  const auto at = mid_.find(key(a, b));
  return at == mid_.end() ? std::nullopt : std::optional(at->second);
}

int PatchMeshBuilder::find_or_add_mid_node(int a, int b) {
  if (const auto known = find_mid_node(a, b)) {
    return *known;
  }
  const Vec3 half = 0.5 * (position(a) + position(b));
  const int node = add_node_at_position(half);
  set_mid_node(a, b, node);
  return node;
}

void PatchMeshBuilder::add_element(base::ElementType type, std::span<const int> corners) {
  PatchElement& element = elements.emplace_back(PatchElement{type, {}});
  element.nodes.assign(corners.begin(), corners.end());
  for (int m = 0; m < shape::edge_count(type); ++m) {
    const auto [a, b] = shape::edge_corners(type, m);
    element.nodes.push_back(find_or_add_mid_node(corners[static_cast<std::size_t>(a)],
                                                 corners[static_cast<std::size_t>(b)]));
  }
}

double PatchMeshBuilder::six_times_volume(int a, int b, int c, int d) const {
  return (local_position(b) - local_position(a))
      .cross(local_position(c) - local_position(a))
      .dot(local_position(d) - local_position(a));
}

void PatchMeshBuilder::move_into_patch(Patch& patch) {
  patch.nodes = std::move(nodes);
  patch.elements = std::move(elements);
  patch.ties = std::move(ties);
}

std::vector<InvalidElement> find_folded_elements(std::span<const PatchNode> nodes,
                                                 std::span<const PatchElement> elements,
                                                 const std::vector<std::size_t>& asked) {
  model::Mesh mesh;
  std::vector<NodeId> number(nodes.size());
  std::vector<NodeId> own_nodes;
  for (const std::size_t e : asked) {
    own_nodes.clear();
    for (const int n : elements[e].nodes) {
      const auto i = static_cast<std::size_t>(n);
      if (!number[i].valid()) {
        number[i] = model::add_node(mesh, nodes[i].x, 0, {});
      }
      own_nodes.push_back(number[i]);
    }
    model::add_element(mesh, elements[e].type, own_nodes, 0, {});
  }
  std::vector<InvalidElement> bad = find_invalid_elements(mesh);
  for (InvalidElement& element : bad) {
    element.element = base::ElementId(asked[element.element.index()]);
  }
  return bad;
}

std::vector<InvalidElement> find_folded_elements(std::span<const PatchNode> nodes,
                                                 std::span<const PatchElement> elements) {
  std::vector<std::size_t> all(elements.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return find_folded_elements(nodes, elements, all);
}

const InvalidElement& most_folded_element(const std::vector<InvalidElement>& folded) {
  return *std::ranges::min_element(folded, {}, &InvalidElement::jacobian);
}

} // namespace spricka::mesh
