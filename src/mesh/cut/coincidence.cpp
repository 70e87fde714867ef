// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/coincidence.hpp"

#include "shape/topology.hpp"

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

/// One number for all points within `reach` of each other: the first such point's. Points are kept
/// by cells much larger than that, so that a look into one of them nearly always tells.
class CoincidentPoints {
public:
  explicit CoincidentPoints(double reach) : reach_(reach), width_(1e3 * reach) {}

  std::int64_t of(const Vec3& x) {
    // The point met before may stand in the next cell: all cells that a box of `reach_` round x
    // touches are looked into.
    const QuadratureCell low = cell_of(x - Vec3::Constant(reach_));
    const QuadratureCell high = cell_of(x + Vec3::Constant(reach_));
    for (std::int64_t i = low[0]; i <= high[0]; ++i) {
      for (std::int64_t j = low[1]; j <= high[1]; ++j) {
        for (std::int64_t k = low[2]; k <= high[2]; ++k) {
          if (const std::int64_t found = find({i, j, k}, x); found >= 0) {
            return found;
          }
        }
      }
    }
    points_.push_back(x);
    const auto number = static_cast<std::int64_t>(points_.size()) - 1;
    cells_[cell_of(x)].push_back(number);
    return number;
  }

private:
  using QuadratureCell = std::array<std::int64_t, 3>;
  struct Hash {
    std::size_t operator()(const QuadratureCell& c) const {
      std::size_t h = 0;
      for (const std::int64_t i : c) {
        h = h * 1000003U + static_cast<std::size_t>(i);
      }
      return h;
    }
  };

  [[nodiscard]] QuadratureCell cell_of(const Vec3& x) const {
    QuadratureCell cell{};
    for (int c = 0; c < 3; ++c) {
      cell[static_cast<std::size_t>(c)] = static_cast<std::int64_t>(std::floor(x[c] / width_));
    }
    return cell;
  }

  // The point of a cell that stands at x; -1: none.
  [[nodiscard]] std::int64_t find(const QuadratureCell& cell, const Vec3& x) const {
    const auto at = cells_.find(cell);
    if (at != cells_.end()) {
      for (const std::int64_t p : at->second) {
        if ((points_[static_cast<std::size_t>(p)] - x).norm() <= reach_) {
          return p;
        }
      }
    }
    return -1;
  }

  double reach_;
  double width_;
  std::vector<Vec3> points_;
  std::unordered_map<QuadratureCell, std::vector<std::int64_t>, Hash> cells_;
};

std::vector<NodeId> corners_of(const model::Mesh& mesh, const model::Face& face) {
  const base::ElementType type = mesh.type[face.element.index()];
  const std::span<const NodeId> nodes = mesh.element_nodes(face.element);
  const std::span<const int> local = shape::side_nodes(type, face.side);
  std::vector<NodeId> corners;
  for (const int i : local.first(shape::side_corners(type, face.side))) {
    corners.push_back(nodes[static_cast<std::size_t>(i)]);
  }
  return corners;
}

double shortest_side(const model::Mesh& mesh, const std::vector<model::Face>& faces) {
  double shortest = std::numeric_limits<double>::max();
  for (const model::Face& face : faces) {
    const std::vector<NodeId> corners = corners_of(mesh, face);
    const Vec3 d = mesh.x[corners[1].index()] - mesh.x[corners[0].index()];
    if (const double length = d.norm(); length > 0.0) {
      shortest = std::min(shortest, length);
    }
  }
  return shortest;
}

} // namespace

std::vector<CoincidentFacePair> find_coincident_faces(const model::Mesh& mesh,
                                                      const std::vector<model::Face>& boundary) {
  if (boundary.empty()) {
    return {};
  }
  CoincidentPoints places(same_place * shortest_side(mesh, boundary));
  std::map<std::vector<std::int64_t>, model::Face> seen;
  std::vector<CoincidentFacePair> list;
  for (const model::Face& face : boundary) {
    std::vector<std::int64_t> key;
    for (const NodeId n : corners_of(mesh, face)) {
      key.push_back(places.of(mesh.x[n.index()]));
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

std::vector<std::pair<base::ElementId, base::ElementId>> doubled_elements(const model::Mesh& mesh) {
  double shortest = std::numeric_limits<double>::max();
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const std::span<const NodeId> nodes = mesh.element_nodes(base::ElementId(e));
    const double length = (mesh.x[nodes[1].index()] - mesh.x[nodes[0].index()]).norm();
    shortest = length > 0.0 ? std::min(shortest, length) : shortest;
  }
  CoincidentPoints places(same_place * shortest);
  std::unordered_map<std::int64_t, base::ElementId> seen;
  std::vector<std::pair<base::ElementId, base::ElementId>> list;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const base::ElementId id(e);
    const std::span<const NodeId> nodes = mesh.element_nodes(id);
    const auto corners = static_cast<std::size_t>(base::element_info(mesh.type[e]).corners);
    // Elements on each other have one centre, which few others share: corners are compared for
    // those only.
    Vec3 middle = Vec3::Zero();
    for (std::size_t i = 0; i < corners; ++i) {
      middle += mesh.x[nodes[i].index()] / static_cast<double>(corners);
    }
    const auto [at, fresh] = seen.try_emplace(places.of(middle), id);
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
