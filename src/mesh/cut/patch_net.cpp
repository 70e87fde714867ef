// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/patch_net.hpp"

#include <algorithm>

namespace spricka::mesh {

using base::NodeId;
using base::Vec2;
using base::Vec3;

int PatchNet::host_node(NodeId n) {
  const auto [at, fresh] = of_host_.try_emplace(n, static_cast<int>(nodes.size()));
  if (fresh) {
    nodes.push_back({host_.x[n.index()], frame_.rounded_local(host_.x[n.index()]), n});
  }
  return at->second;
}

int PatchNet::new_node(const Vec3& x) {
  nodes.push_back({x, frame_.rounded_local(x), {}});
  return static_cast<int>(nodes.size()) - 1;
}

int PatchNet::new_node(const Vec2& place) {
  nodes.push_back({frame_.global(place), {rounded(place.x()), rounded(place.y())}, {}});
  return static_cast<int>(nodes.size()) - 1;
}

int PatchNet::mid_node(int a, int b) {
  const auto [at, fresh] = mid_.try_emplace(std::minmax(a, b), 0);
  if (fresh) {
    const Vec3 half = 0.5 * (position(a) + position(b));
    at->second = new_node(half);
  }
  return at->second;
}

void PatchNet::add_triangle(int a, int b, int c) {
  elements.push_back(
      {base::ElementType::trimc6, {a, b, c, mid_node(a, b), mid_node(b, c), mid_node(c, a)}});
}

void PatchNet::add_quadrilateral(int a, int b, int c, int d) {
  elements.push_back(
      {base::ElementType::quamc8,
       {a, b, c, d, mid_node(a, b), mid_node(b, c), mid_node(c, d), mid_node(d, a)}});
}

} // namespace spricka::mesh
