// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/solid_net.hpp"

#include <Eigen/Geometry>

#include <algorithm>

namespace spricka::mesh {

using base::NodeId;
using base::Vec3;

int SolidNet::host_node(NodeId n) {
  const auto [at, fresh] = of_host_.try_emplace(n.value, static_cast<int>(nodes.size()));
  if (fresh) {
    nodes.push_back({host_.x[n.index()], frame_.local(host_.x[n.index()]), n});
  }
  return at->second;
}

int SolidNet::new_node(const Vec3& x) {
  nodes.push_back({x, frame_.local(x), {}});
  return static_cast<int>(nodes.size()) - 1;
}

int SolidNet::new_node_at(const Vec3& place) {
  nodes.push_back({frame_.global(place), rounded(place), {}});
  return static_cast<int>(nodes.size()) - 1;
}

int SolidNet::copy(int n) {
  SolidPatchNode node = nodes[static_cast<std::size_t>(n)];
  node.host = {};
  nodes.push_back(node);
  return static_cast<int>(nodes.size()) - 1;
}

std::optional<int> SolidNet::known_mid(int a, int b) const {
  const auto at = mid_.find(key(a, b));
  return at == mid_.end() ? std::nullopt : std::optional(at->second);
}

int SolidNet::mid(int a, int b) {
  if (const auto known = known_mid(a, b)) {
    return *known;
  }
  const Vec3 half = 0.5 * (x(a) + x(b));
  const int node = new_node(half);
  set_mid(a, b, node);
  return node;
}

double SolidNet::six_volumes(int a, int b, int c, int d) const {
  return (local(b) - local(a)).cross(local(c) - local(a)).dot(local(d) - local(a));
}

} // namespace spricka::mesh
