// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/patch_fill.hpp"

#include "mesh/link/fill.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>

namespace spricka::mesh {

std::string triangulate_patch(PatchMeshBuilder& net, const PatchContours& contours,
                              const Grading& size) {
  PlaneRegion region;
  std::map<int, int> place; // patch node -> point
  std::vector<int> node;    // and back
  const auto point = [&](int n) {
    const auto [at, fresh] = place.try_emplace(n, static_cast<int>(node.size()));
    if (fresh) {
      node.push_back(n);
      region.points.push_back(net.local_position(n).head<2>());
    }
    return at->second;
  };
  const auto points = [&](const std::vector<int>& chain) {
    std::vector<int> result;
    std::transform(chain.begin(), chain.end(), std::back_inserter(result), point);
    return result;
  };
  for (const std::vector<int>& loop : contours.loops) {
    region.boundaries.push_back(points(loop));
  }
  for (const std::vector<int>& line : contours.embedded) {
    region.embedded.push_back(points(line));
  }
  const TriangleFill filling = fill_triangles(region, size);
  if (!filling.trouble.empty()) {
    return filling.trouble;
  }
  for (const base::Vec2& p : filling.added) {
    node.push_back(net.add_node_at_local_position(base::embed_in_space(p)));
  }
  for (const std::array<int, 3>& t : filling.cells) {
    PatchTriangle corners{};
    std::ranges::transform(t, corners.begin(),
                           [&](int n) { return node[static_cast<std::size_t>(n)]; });
    net.add_element(base::ElementType::trimc6, corners);
  }
  return {};
}

} // namespace spricka::mesh
