// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/symmetry_line.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spricka::mesh {

using base::NodeId;
using base::Vec2;

bool SymmetryLine::contains(const CavityOutlineEdge& edge) const {
  // Ahead of the mouth only: the boundary may go on straight behind it.
  const auto local = [&](double xi) { return point_on_edge(host_, frame_, edge.edge, xi); };
  return edge.free && std::abs(local(-1.0).y()) < coordinate_tolerance &&
         std::abs(local(0.0).y()) < coordinate_tolerance &&
         std::abs(local(1.0).y()) < coordinate_tolerance &&
         std::max(local(-1.0).x(), local(1.0).x()) > coordinate_tolerance;
}

SymmetryLine::SymmetryLineEnd SymmetryLine::farthest_end() const {
  SymmetryLineEnd result;
  for (const CavityOutlineEdge& edge : edges_) {
    for (const NodeId n : {edge.edge.a, edge.edge.b}) {
      const double x = frame_.rounded_local_coordinates(host_.x[n.index()]).x();
      if (x > result.x) {
        result = {n, x};
      }
    }
  }
  return result;
}

std::vector<HostFaceReplacement>
SymmetryLine::edge_replacements(const PatchMeshBuilder& net, const std::vector<int>& line) const {
  std::vector<HostFaceReplacement> result;
  for (const CavityOutlineEdge& edge : edges_) {
    const double x0 = point_on_edge(host_, frame_, edge.edge, -1.0).x();
    const double x1 = point_on_edge(host_, frame_, edge.edge, 1.0).x();
    std::vector<std::vector<int>> pieces;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const double x =
          0.5 * (net.local_position(line[i]).x() + net.local_position(line[i + 1]).x());
      // Half-open: a piece whose middle meets the end of two host edges goes to one of them.
      if (x >= std::min(x0, x1) - coordinate_tolerance &&
          x < std::max(x0, x1) - coordinate_tolerance) {
        pieces.push_back({line[i], line[i + 1]});
      }
    }
    if (x1 < x0) { // in the direction of the host's edge
      std::reverse(pieces.begin(), pieces.end());
      for (std::vector<int>& piece : pieces) {
        std::ranges::reverse(piece);
      }
    }
    result.emplace_back(edge.face, std::move(pieces));
  }
  return result;
}

bool insert_contour_into_loop(std::vector<std::vector<int>>& loops,
                              const std::vector<int>& contour) {
  for (std::vector<int>& loop : loops) {
    const auto first = std::find(loop.begin(), loop.end(), contour.front());
    if (first == loop.end()) {
      continue;
    }
    std::rotate(loop.begin(), first, loop.end());
    // What stands between are host nodes of the line, in whose place the contour's come.
    const auto last = std::find(loop.begin(), loop.end(), contour.back());
    std::vector<int> whole(contour.begin(), contour.end() - 1);
    whole.insert(whole.end(), last, loop.end());
    loop = std::move(whole);
    return true;
  }
  return false;
}

} // namespace spricka::mesh
