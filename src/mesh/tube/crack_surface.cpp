// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/crack_surface.hpp"

#include "mesh/link/fill.hpp"
#include "mesh/plane.hpp"
#include "mesh/tube/crack_bends.hpp"

#include <algorithm>

namespace spricka::mesh {

using base::Vec2;

CrackTriangulation triangulate_crack_area(const CrackDistanceField& reach,
                                          const std::vector<std::vector<int>>& loops, double finer,
                                          PatchMeshBuilder& net) {
  CrackTriangulation surface;
  PlaneRegion region;
  // Layers of elements round a free front are to be alike.
  constexpr double growth_at_free = 0.15;
  const double growth =
      (reach.has_tubeless_front() ? growth_at_free : CrackDistanceField::usual_growth) / finer;
  Grading size(growth);
  for (const std::vector<int>& nodes : loops) {
    std::vector<int> loop;
    for (const int n : nodes) {
      const Vec2 q = reach.plane().project(net.local_position(n));
      loop.push_back(static_cast<int>(region.points.size()));
      region.points.emplace_back(rounded(q.x()), rounded(q.y()));
      surface.nodes.push_back(n);
      const CrackDistanceField::CrackDistances d = reach.distance(net.local_position(n));
      const double wanted =
          size_at_front_distance(d, CrackDistanceField::usual_growth / finer) / finer;
      size.add_size_source(region.points.back(), rounded(wanted));
    }
    if ((twice_area(region.points, loop) < 0.0) == region.boundaries.empty()) {
      std::reverse(loop.begin(), loop.end());
    }
    region.boundaries.push_back(std::move(loop));
  }
  for (const KinkLine& bend : build_kink_lines(reach, finer, surface.nodes, net)) {
    std::vector<int>& chain = region.embedded.emplace_back();
    for (const KinkLinePoint& point : bend.points) {
      if (point.node >= 0) { // one of a mouth
        const auto at = std::ranges::find(surface.nodes, point.node);
        chain.push_back(static_cast<int>(at - surface.nodes.begin()));
        continue;
      }
      const Vec2 q = reach.plane().project(point.x);
      chain.push_back(static_cast<int>(region.points.size()));
      region.points.emplace_back(rounded(q.x()), rounded(q.y()));
      surface.nodes.push_back(net.add_node_at_local_position(point.x));
      size.add_size_source(region.points.back(), rounded(point.size));
    }
    if (bend.closed) {
      chain.push_back(chain.front());
    }
  }
  const TriangleFill filling = fill_triangles(region, size);
  surface.trouble = filling.trouble;
  for (const Vec2& q : filling.added) {
    surface.nodes.push_back(net.add_node_at_local_position(reach.plane().lift_to_crack(q)));
  }
  for (const std::array<int, 3>& t : filling.cells) {
    PatchTriangle triangle{};
    std::ranges::transform(t, triangle.begin(),
                           [&](int n) { return surface.nodes[static_cast<std::size_t>(n)]; });
    surface.triangles.push_back(triangle);
  }
  return surface;
}

} // namespace spricka::mesh
