// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/solid_net.hpp"

#include <Eigen/Geometry>

#include <algorithm>

namespace spricka::mesh {

using base::NodeId;
using base::Vec3;

int SolidPatchNet::host_node(NodeId n) {
  const auto [at, fresh] = of_host_.try_emplace(n.value, static_cast<int>(nodes.size()));
  if (fresh) {
    nodes.push_back({host_.x[n.index()], frame_.rounded_local(host_.x[n.index()]), n});
  }
  return at->second;
}

int SolidPatchNet::new_node(const Vec3& x) {
  nodes.push_back({x, frame_.rounded_local(x), {}});
  return static_cast<int>(nodes.size()) - 1;
}

int SolidPatchNet::new_node_at(const Vec3& place) {
  nodes.push_back({frame_.global(place), rounded(place), {}});
  return static_cast<int>(nodes.size()) - 1;
}

int SolidPatchNet::duplicate_node(int n) {
  SolidPatchNode node = nodes[static_cast<std::size_t>(n)];
  node.host = {};
  nodes.push_back(node);
  return static_cast<int>(nodes.size()) - 1;
}

std::optional<int> SolidPatchNet::known_mid_node(int a, int b) const {
  const auto at = mid_.find(key(a, b));
  return at == mid_.end() ? std::nullopt : std::optional(at->second);
}

int SolidPatchNet::mid_node(int a, int b) {
  if (const auto known = known_mid_node(a, b)) {
    return *known;
  }
  const Vec3 half = 0.5 * (position(a) + position(b));
  const int node = new_node(half);
  set_mid_node(a, b, node);
  return node;
}

double SolidPatchNet::six_volumes(int a, int b, int c, int d) const {
  return (local_position(b) - local_position(a))
      .cross(local_position(c) - local_position(a))
      .dot(local_position(d) - local_position(a));
}

} // namespace spricka::mesh
