// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/gmsh_sizes.hpp"

#include "base/vec.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace spricka::mesher {

namespace {

// A curve is left alone while its elements are no longer than this times what is wanted.
constexpr double near_enough = 1.1;
// Points of a curve where its sizes are looked up, for each of its elements and in all.
constexpr double looks_each = 20.0;
constexpr double most_looks = 1e5;

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

/// Where a curve is to have its inner nodes.
struct Stations {
  std::vector<double> t; ///< parameters, rising
  std::vector<double> x; ///< three coordinates each
};

// Each element takes the same part of the integral of ds / size along the curve.
Stations stations_of(int curve, const std::function<double(double, double)>& size) {
  std::vector<double> low;
  std::vector<double> high;
  gmsh::model::getParametrizationBounds(1, curve, low, high);
  std::vector<double> t;
  std::vector<double> x;
  std::vector<double> elements; // up to t
  const auto look = [&](std::size_t pieces) {
    t.resize(pieces + 1);
    for (std::size_t i = 0; i <= pieces; ++i) {
      t[i] = low[0] + (high[0] - low[0]) * static_cast<double>(i) / static_cast<double>(pieces);
    }
    gmsh::model::getValue(1, curve, t, x);
    elements.assign(1, 0.0);
    double most = 0.0; // elements in one piece
    for (std::size_t i = 0; i < pieces; ++i) {
      const base::Vec2 a(x[3 * i], x[3 * i + 1]);
      const base::Vec2 b(x[3 * i + 3], x[3 * i + 4]);
      const base::Vec2 middle = 0.5 * (a + b);
      const double in_piece = (b - a).norm() / size(middle.x(), middle.y());
      elements.push_back(elements.back() + in_piece);
      most = std::max(most, in_piece);
    }
    return most;
  };
  constexpr std::size_t first_looks = 200;
  const double most = look(first_looks);
  const double needed = std::min(looks_each * most * first_looks, most_looks);
  if (needed > first_looks) {
    look(static_cast<std::size_t>(needed));
  }
  const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(elements.back() - 1e-6)));
  Stations stations;
  for (std::size_t k = 1, i = 0; k < count; ++k) {
    const double target = elements.back() * static_cast<double>(k) / static_cast<double>(count);
    while (elements[i + 1] < target) {
      ++i;
    }
    const double part = (target - elements[i]) / (elements[i + 1] - elements[i]);
    stations.t.push_back(t[i] + part * (t[i + 1] - t[i]));
  }
  if (!stations.t.empty()) {
    gmsh::model::getValue(1, curve, stations.t, stations.x);
  }
  return stations;
}

// The inner nodes of a curve that gmsh has given as many elements as there are stations and one.
void move_nodes(int curve, const Stations& stations) {
  std::vector<std::size_t> tags;
  std::vector<double> x;
  std::vector<double> t;
  gmsh::model::mesh::getNodes(tags, x, t, 1, curve);
  if (tags.size() != stations.t.size() || t.size() != tags.size()) {
    return; // a copy of another curve (Periodic Curve), or part of an extrusion
  }
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < tags.size(); ++i) {
    order.emplace_back(t[i], tags[i]);
  }
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto at = stations.x.begin() + static_cast<std::ptrdiff_t>(3 * i);
    gmsh::model::mesh::setNode(order[i].second, {at, at + 3}, {stations.t[i]});
  }
}

} // namespace

void apply_sizes_and_mesh_curves(const mesh::ScriptSizeMap& size) {
  double order = 1.0;
  gmsh::option::getNumber("Mesh.ElementOrder", order);
  gmsh::option::setNumber("Mesh.ElementOrder", 1.0);
  gmsh::model::mesh::generate(1);
  gmsh::vectorpair curves;
  gmsh::model::getEntities(curves, 1);
  std::map<int, Stations> moved;
  for (const auto& [dim, curve] : curves) {
    const std::vector<Spacing> before = spacing_of(curve);
    const bool coarse = std::any_of(before.begin(), before.end(), [&](const Spacing& s) {
      return s.length > near_enough * size(s.at.x(), s.at.y());
    });
    if (coarse) {
      moved.emplace(curve, stations_of(curve, [&](double x, double y) {
                      return std::min(size(x, y), nearest_length(before, {x, y}));
                    }));
    }
  }
  gmsh::model::mesh::clear();
  // gmsh can't take back what a script says of a curve (Transfinite), only say it anew
  for (const auto& [curve, stations] : moved) {
    gmsh::model::mesh::setTransfiniteCurve(curve, static_cast<int>(stations.t.size()) + 2);
  }
  gmsh::model::mesh::setSizeCallback(
      [size](int /*dim*/, int /*tag*/, double x, double y, double /*z*/) { return size(x, y); });
  gmsh::model::mesh::generate(1);
  for (const auto& [curve, stations] : moved) {
    move_nodes(curve, stations);
  }
  gmsh::option::setNumber("Mesh.ElementOrder", order);
}

} // namespace spricka::mesher
