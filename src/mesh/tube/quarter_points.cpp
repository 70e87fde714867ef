// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/quarter_points.hpp"

#include "mesh/cut/patch_net.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <map>

namespace spricka::mesh {
namespace {

using base::Vec3;

class QuarterMover {
public:
  QuarterMover(PatchMeshBuilder& net, const std::set<int>& front,
               const std::vector<std::pair<int, int>>& twins)
      : net_(net) {
    for (const auto& [upper, lower] : twins) {
      upper_of_[lower] = upper;
    }
    for (std::size_t e = 0; e < net_.elements.size(); ++e) {
      collect(e, front);
    }
  }

  QuarterPointCounts move() {
    QuarterPointCounts count;
    count.moved = edges_.size();
    for (auto& [mid, edge] : edges_) {
      put(edge, true);
    }
    // What is put back makes room; an element whose edges are all back is the fill's own.
    while (put_back()) {
    }
    count.left = static_cast<std::size_t>(
        std::ranges::count_if(edges_, [](const auto& entry) { return !entry.second.quarter; }));
    count.moved -= count.left;
    return count;
  }

private:
  struct Mid {
    int node = 0;
    Vec3 half, quarter;
  };
  /// An edge, on the faces of a crack both of them.
  struct QuarterPointEdge {
    std::map<int, Mid> mids;
    std::set<std::size_t> elements;
    bool quarter = false;
  };

  void collect(std::size_t e, const std::set<int>& front) {
    const PatchElement& element = net_.elements[e];
    for (int m = 0; m < shape::edge_count(element.type); ++m) {
      const auto ends = shape::edge_corners(element.type, m);
      int from = element.nodes[static_cast<std::size_t>(ends[0])];
      int to = element.nodes[static_cast<std::size_t>(ends[1])];
      if (front.contains(from) == front.contains(to)) {
        continue;
      }
      if (front.contains(to)) {
        std::swap(from, to);
      }
      const auto corners = static_cast<std::size_t>(base::element_info(element.type).corners);
      const int mid = element.nodes[corners + static_cast<std::size_t>(m)];
      const auto twin = upper_of_.find(mid);
      QuarterPointEdge& edge = edges_[twin == upper_of_.end() ? mid : twin->second];
      // The parabola through the edge's nodes, at a quarter (mesh.14).
      const Vec3& half = net_.position(mid);
      edge.mids.try_emplace(
          mid,
          Mid{mid, half, 0.375 * net_.position(from) + 0.75 * half - 0.125 * net_.position(to)});
      edge.elements.insert(e);
    }
  }

  void put(QuarterPointEdge& edge, bool quarter) {
    edge.quarter = quarter;
    for (const auto& [node, mid] : edge.mids) {
      net_.nodes[static_cast<std::size_t>(node)].x = quarter ? mid.quarter : mid.half;
    }
  }

  /// The edges of elements that are folded; false if there is none.
  bool put_back() {
    std::set<std::size_t> touched;
    for (const auto& [mid, edge] : edges_) {
      if (edge.quarter) {
        touched.insert(edge.elements.begin(), edge.elements.end());
      }
    }
    std::set<std::size_t> bad;
    for (const InvalidElement& element :
         find_folded_elements(net_.nodes, net_.elements, {touched.begin(), touched.end()})) {
      bad.insert(element.element.index());
    }
    for (auto& [mid, edge] : edges_) {
      if (edge.quarter &&
          std::ranges::any_of(edge.elements, [&](std::size_t e) { return bad.contains(e); })) {
        put(edge, false);
      }
    }
    return !bad.empty();
  }

  PatchMeshBuilder& net_;
  std::map<int, int> upper_of_;           ///< of two nodes at one place
  std::map<int, QuarterPointEdge> edges_; ///< [mid node, the upper one of two]
};

} // namespace

QuarterPointCounts move_mid_nodes_to_quarters(PatchMeshBuilder& net, const std::set<int>& front,
                                              const std::vector<std::pair<int, int>>& twins) {
  return QuarterMover(net, front, twins).move();
}

} // namespace spricka::mesh
