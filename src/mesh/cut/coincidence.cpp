// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/coincidence.hpp"

#include "mesh/boundary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

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
  add(cell_of(x), x);
  return points_.size() - 1;
}

CoincidentPoints::Cell CoincidentPoints::cell_of(const Vec3& x) const {
  Cell cell{};
  for (int c = 0; c < 3; ++c) {
    cell[static_cast<std::size_t>(c)] = static_cast<std::int64_t>(std::floor(x[c] / width_));
  }
  return cell;
}

// Where a cell stands in the table, or would stand.
std::size_t CoincidentPoints::slot_of(const Cell& cell) const {
  std::size_t h = 0;
  for (const std::int64_t i : cell) {
    h = (h + static_cast<std::size_t>(i)) * 0x9e3779b97f4a7c15ULL;
    h ^= h >> 32U;
  }
  const std::size_t mask = last_.size() - 1;
  std::size_t slot = h & mask;
  while (last_[slot] != none && cell_[last_[slot]] != cell) {
    slot = (slot + 1) & mask;
  }
  return slot;
}

std::optional<std::size_t> CoincidentPoints::find(const Cell& cell, const Vec3& x) const {
  std::optional<std::size_t> first;
  if (!last_.empty()) {
    for (std::size_t p = last_[slot_of(cell)]; p != none; p = previous_[p]) {
      if ((points_[p] - x).norm() <= reach_) {
        first = p;
      }
    }
  }
  return first;
}

void CoincidentPoints::add(const Cell& cell, const Vec3& x) {
  if (2 * used_ >= last_.size()) {
    widen();
  }
  std::size_t& last = last_[slot_of(cell)];
  used_ += last == none ? 1 : 0;
  previous_.push_back(last);
  last = points_.size();
  points_.push_back(x);
  cell_.push_back(cell);
}

void CoincidentPoints::widen() {
  constexpr std::size_t least = 64;
  std::vector<std::size_t> old(std::max(least, 4 * last_.size()), none);
  last_.swap(old);
  for (const std::size_t last : old) {
    if (last != none) {
      last_[slot_of(cell_[last])] = last;
    }
  }
}

std::vector<CoincidentFacePair> find_coincident_faces(const model::Mesh& mesh,
                                                      const std::vector<model::Face>& boundary) {
  if (boundary.empty()) {
    return {};
  }
  constexpr std::size_t unknown = static_cast<std::size_t>(-1);
  CoincidentPoints places(same_place * shortest_side(mesh, boundary));
  std::vector<std::size_t> place(mesh.node_count(), unknown); // of corners of the boundary
  bool shared = false;
  std::size_t met = 0;
  for (const model::Face& face : boundary) {
    const FaceNodes nodes = face_nodes(mesh, face);
    for (const NodeId n : nodes.corner_nodes()) {
      if (std::size_t& number = place[n.index()]; number == unknown) {
        number = places.find_or_add_number(mesh.x[n.index()]);
        shared = shared || number < met;
        met += number == met ? 1 : 0;
      }
    }
  }
  if (!shared) {
    return {}; // no two corners at one place, and no side has all corners of another
  }
  std::map<std::vector<std::size_t>, model::Face> seen;
  std::vector<CoincidentFacePair> list;
  for (const model::Face& face : boundary) {
    std::vector<std::size_t> key;
    const FaceNodes nodes = face_nodes(mesh, face);
    for (const NodeId n : nodes.corner_nodes()) {
      key.push_back(place[n.index()]);
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
  std::vector<base::ElementId> seen; // [place] the first element there
  std::vector<std::pair<base::ElementId, base::ElementId>> list;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const base::ElementId id(e);
    const std::span<const NodeId> nodes = mesh.element_nodes(id);
    const auto corners = static_cast<std::size_t>(base::element_info(mesh.type[e]).corners);
    // Elements on each other have one centre, which few others share: corners are compared for
    // those only.
    const std::size_t place = places.find_or_add_number(model::element_corner_mean(mesh, id));
    if (place == seen.size()) {
      seen.push_back(id);
      continue;
    }
    // elements about one centre that are not on each other: rings of an odd mesh
    const std::span<const NodeId> others = mesh.element_nodes(seen[place]);
    const bool all = std::ranges::all_of(nodes.first(corners), [&](NodeId n) {
      return std::ranges::any_of(others, [&](NodeId o) {
        return (mesh.x[n.index()] - mesh.x[o.index()]).norm() <= same_place * shortest;
      });
    });
    if (all) {
      list.emplace_back(seen[place], id);
    }
  }
  return list;
}

} // namespace spricka::mesh
