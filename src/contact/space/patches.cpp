// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space/patches.hpp"

#include "base/disjoint_sets.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace spricka::contact {

namespace {

const double most_turn = std::cos(std::numbers::pi / 6.0);

using Edge3 = std::pair<base::NodeId, base::NodeId>; ///< corners, the smaller first

// Unit normal of a face in the middle between two corners that follow one another.
Vec3 normal_on_edge(const geometry::ElementSide& face, int corner, int next) {
  const Vec2 r = 0.5 * (face.node_local_coordinates(corner) + face.node_local_coordinates(next));
  return face.area_vector(r).normalized();
}

} // namespace

std::vector<std::size_t> smooth_part_numbers(const std::vector<geometry::ElementSide>& faces) {
  base::DisjointSets smooth(faces.size());
  struct Side {
    std::size_t face = 0;
    Vec3 normal = Vec3::Zero();
  };
  std::map<Edge3, Side> met;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const int corners = faces[f].corner_count();
    for (int i = 0; i < corners; ++i) {
      const int next = (i + 1) % corners;
      const base::NodeId a = faces[f].nodes[static_cast<std::size_t>(i)];
      const base::NodeId b = faces[f].nodes[static_cast<std::size_t>(next)];
      const Side side{f, normal_on_edge(faces[f], i, next)};
      const auto [at, fresh] = met.try_emplace(std::minmax(a, b), side);
      if (!fresh && at->second.normal.dot(side.normal) > most_turn) {
        smooth.join_sets(at->second.face, f);
      }
    }
  }
  return smooth.set_numbers().of;
}

} // namespace spricka::contact
