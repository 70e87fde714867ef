// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/free_front.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace spricka::mesh {
namespace {

using base::Vec3;

/// Size of the elements at a free front over the radius of the tube that it stands for.
constexpr double size_of_radius = 0.5;
/// Elements along the front over those across it.
constexpr double shortest_edge = 0.5;

double size_at_front(double radius, const TubeMeshParameters& given) {
  return given.size > 0.0 ? std::min(given.size / given.finer, radius) : size_of_radius * radius;
}

} // namespace

TubeSizes tubeless_front_sizes(TubeSizes sizes, const TubeMeshParameters& given) {
  for (std::size_t i = 0; i < sizes.s.size(); ++i) {
    const double size = size_at_front(sizes.radius[i], given);
    sizes.length[i] = std::clamp(sizes.length[i], shortest_edge * size, size);
  }
  return sizes;
}

Tube make_tubeless_front(const FrontCurve& curve, const TubeSizes& sizes,
                         const TubeMeshParameters& given) {
  Tube tube;
  tube.closed = curve.closed();
  tube.free = true;
  tube.quarter_point = given.quarter_point;
  const std::vector<double> at = sizes.stations(curve.closed());
  const auto add = [&](const Vec3& x) {
    tube.x.push_back(x);
    const int node = static_cast<int>(tube.x.size()) - 1;
    tube.twins.emplace_back(node, node);
    return node;
  };
  for (const double s : at) {
    tube.stations.push_back(curve.at(s));
    tube.radius.push_back(sizes.radius_at(s));
    tube.size.push_back(size_at_front(tube.radius.back(), given));
    tube.front.push_back(add(tube.stations.back().x));
  }
  for (std::size_t i = 0; i + (tube.closed ? 0 : 1) < at.size(); ++i) {
    const double end = i + 1 < at.size() ? at[i + 1] : curve.length();
    // On the curve: with chords K1 of a penny scatters by 1.7 % in place of 0.9 %.
    tube.front_mid.push_back(add(curve.at(0.5 * (at[i] + end)).x));
  }
  tube.upper = tube.front;
  tube.lower = tube.front;
  if (!tube.closed) {
    tube.ends[0].corner = {tube.front.front()};
    tube.ends[1].corner = {tube.front.back()};
  }
  return tube;
}

void divide_front_chord_edges(const PlaneBasis& plane, const std::set<int>& front,
                              PatchMeshBuilder& net, CrackTriangulation& surface) {
  using Edge = std::pair<int, int>;
  std::map<Edge, std::vector<std::size_t>> chords;
  // Triangles that come of a division are looked at again: they may have a second chord.
  for (bool more = true; more;) {
    more = false;
    chords.clear();
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [a, b] = std::minmax(surface.triangles[t][i], surface.triangles[t][(i + 1) % 3]);
        if (front.contains(a) && front.contains(b)) {
          chords[{a, b}].push_back(t);
        }
      }
    }
    for (const auto& [edge, beside] : chords) {
      if (beside.size() < 2) { // an edge of the front
        continue;
      }
      const Vec3 half = 0.5 * (net.local_position(edge.first) + net.local_position(edge.second));
      const int middle = net.add_node_at_local_position(plane.lift_to_crack(plane.project(half)));
      surface.nodes.push_back(middle);
      for (const std::size_t t : beside) {
        PatchTriangle other = surface.triangles[t];
        std::ranges::replace(surface.triangles[t], edge.first, middle);
        std::ranges::replace(other, edge.second, middle);
        surface.triangles.push_back(other);
      }
      more = true;
      break;
    }
  }
}

} // namespace spricka::mesh
