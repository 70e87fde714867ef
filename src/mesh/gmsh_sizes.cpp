// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/gmsh_sizes.hpp"

#include "base/vec.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace spricka::mesh {

namespace {

// A curve is left alone while its elements are no longer than this times what is wanted.
constexpr double near_enough = 1.1;

struct Spacing {
  base::Vec2 at;
  double length = 0.0;
};

// Elements of a curve as the script alone would have them: where, and how long.
std::vector<Spacing> spacing_of(int curve) {
  std::vector<std::size_t> tags;
  std::vector<double> x;
  std::vector<double> parametric;
  gmsh::model::mesh::getNodes(tags, x, parametric, 1, curve, true);
  std::unordered_map<std::size_t, base::Vec2> place;
  for (std::size_t i = 0; i < tags.size(); ++i) {
    place[tags[i]] = {x[3 * i], x[3 * i + 1]};
  }
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> elements;
  std::vector<std::vector<std::size_t>> nodes;
  gmsh::model::mesh::getElements(types, elements, nodes, 1, curve);
  std::vector<Spacing> spacing;
  for (std::size_t t = 0; t < types.size(); ++t) {
    const std::size_t each = elements[t].empty() ? 1 : nodes[t].size() / elements[t].size();
    for (std::size_t e = 0; e < elements[t].size(); ++e) {
      const base::Vec2& a = place[nodes[t][e * each]];
      const base::Vec2& b = place[nodes[t][e * each + 1]];
      spacing.push_back({0.5 * (a + b), (b - a).norm()});
    }
  }
  return spacing;
}

double nearest_length(const std::vector<Spacing>& spacing, const base::Vec2& p) {
  double closest = std::numeric_limits<double>::infinity();
  double length = closest;
  for (const Spacing& s : spacing) {
    const double distance = (s.at - p).squaredNorm();
    if (distance < closest) {
      closest = distance;
      length = s.length;
    }
  }
  return length;
}

} // namespace

void wish_for_sizes(const SizeWish& size) {
  gmsh::model::mesh::generate(1);
  gmsh::vectorpair curves;
  gmsh::model::getEntities(curves, 1);
  gmsh::vectorpair freed;
  std::map<int, std::vector<Spacing>> before;
  for (const auto& [dim, curve] : curves) {
    std::vector<Spacing> spacing = spacing_of(curve);
    const bool coarse = std::any_of(spacing.begin(), spacing.end(), [&](const Spacing& s) {
      return s.length > near_enough * size(s.at.x(), s.at.y());
    });
    if (coarse) {
      freed.emplace_back(dim, curve);
      before.emplace(curve, std::move(spacing));
    }
  }
  gmsh::model::mesh::clear();
  if (!freed.empty()) {
    gmsh::model::mesh::removeConstraints(freed);
  }
  gmsh::model::mesh::setSizeCallback(
      [size, before](int dim, int tag, double x, double y, double /*z*/) {
        const double wish = size(x, y);
        const auto curve = dim == 1 ? before.find(tag) : before.end();
        return curve == before.end() ? wish : std::min(wish, nearest_length(curve->second, {x, y}));
      });
}

} // namespace spricka::mesh
