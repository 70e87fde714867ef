// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/coincidence.hpp"

#include "mesh/boundary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <unordered_map>

namespace spricka::mesh {

namespace {

using base::NodeId;
using base::Vec3;

constexpr double same_place = 1e-4; // part of the shortest side

double shortest_side(const model::Mesh& mesh, const std::vector<model::Face>& faces) {
  double shortest = std::numeric_limits<double>::max();
  for (const model::Face& face : faces) {
    const FaceNodes nodes = face_nodes(mesh, face);
    const Vec3 d = mesh.x[nodes.all[1].index()] - mesh.x[nodes.all[0].index()];
    if (const double length = d.norm(); length > 0.0) {
      shortest = std::min(shortest, length);
    }
  }
  return shortest;
}

} // namespace

std::size_t CoincidentPoints::GridCellHasher::operator()(const Cell& cell) const {
  std::size_t h = 0;
  for (const std::int64_t i : cell) {
    h = h * 1000003U + static_cast<std::size_t>(i);
  }
  return h;
}

std::size_t CoincidentPoints::find_or_add_number(const Vec3& x) {
  // The point met before may stand in the next cell: all cells that a box of `reach_` round x
  // touches are looked into.
  const Cell low = cell_of(x - Vec3::Constant(reach_));
  const Cell high = cell_of(x + Vec3::Constant(reach_));
  for (std::int64_t i = low[0]; i <= high[0]; ++i) {
    for (std::int64_t j = low[1]; j <= high[1]; ++j) {
      for (std::int64_t k = low[2]; k <= high[2]; ++k) {
        if (const auto found = find({i, j, k}, x)) {
          return *found;
        }
      }
    }
  }
  cells_[cell_of(x)].push_back(points_.size());
  points_.push_back(x);
  return points_.size() - 1;
}

CoincidentPoints::Cell CoincidentPoints::cell_of(const Vec3& x) const {
  Cell cell{};
  for (int c = 0; c < 3; ++c) {
    cell[static_cast<std::size_t>(c)] = static_cast<std::int64_t>(std::floor(x[c] / width_));
  }
  return cell;
}

std::optional<std::size_t> CoincidentPoints::find(const Cell& cell, const Vec3& x) const {
  const auto at = cells_.find(cell);
  if (at == cells_.end()) {
    return std::nullopt;
  }
  const auto point = std::ranges::find_if(
      at->second, [&](std::size_t p) { return (points_[p] - x).norm() <= reach_; });
  return point == at->second.end() ? std::nullopt : std::optional(*point);
}

std::vector<CoincidentFacePair> find_coincident_faces(const model::Mesh& mesh,
                                                      const std::vector<model::Face>& boundary) {
  if (boundary.empty()) {
    return {};
  }
  CoincidentPoints places(same_place * shortest_side(mesh, boundary));
  std::map<std::vector<std::size_t>, model::Face> seen;
  std::vector<CoincidentFacePair> list;
  for (const model::Face& face : boundary) {
    std::vector<std::size_t> key;
    const FaceNodes nodes = face_nodes(mesh, face);
    for (const NodeId n : nodes.corner_nodes()) {
      key.push_back(places.find_or_add_number(mesh.x[n.index()]));
    }
    // Sides that lie on each other run against each other: the order of corners says nothing.
    std::ranges::sort(key);
    const auto [at, fresh] = seen.try_emplace(std::move(key), face);
    if (!fresh) {
      list.push_back({at->second, face});
    }
  }
  return list;
}

std::vector<std::pair<base::ElementId, base::ElementId>>
find_coincident_elements(const model::Mesh& mesh) {
  double shortest = std::numeric_limits<double>::max();
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const std::span<const NodeId> nodes = mesh.element_nodes(base::ElementId(e));
    const double length = (mesh.x[nodes[1].index()] - mesh.x[nodes[0].index()]).norm();
    shortest = length > 0.0 ? std::min(shortest, length) : shortest;
  }
  CoincidentPoints places(same_place * shortest);
  std::unordered_map<std::size_t, base::ElementId> seen;
  std::vector<std::pair<base::ElementId, base::ElementId>> list;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const base::ElementId id(e);
    const std::span<const NodeId> nodes = mesh.element_nodes(id);
    const auto corners = static_cast<std::size_t>(base::element_info(mesh.type[e]).corners);
    // Elements on each other have one centre, which few others share: corners are compared for
    // those only.
    const auto [at, fresh] =
        seen.try_emplace(places.find_or_add_number(model::element_corner_mean(mesh, id)), id);
    if (fresh) {
      continue;
    }
    // elements about one centre that are not on each other: rings of an odd mesh
    const std::span<const NodeId> others = mesh.element_nodes(at->second);
    const bool all = std::ranges::all_of(nodes.first(corners), [&](NodeId n) {
      return std::ranges::any_of(others, [&](NodeId o) {
        return (mesh.x[n.index()] - mesh.x[o.index()]).norm() <= same_place * shortest;
      });
    });
    if (all) {
      list.emplace_back(at->second, id);
    }
  }
  return list;
}

} // namespace spricka::mesh
