// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <array>
#include <cstdint>
#include <vector>

/// The edges of quadratic plane elements: modes of a side belong to all elements that share it.
namespace spricka::estimate {

struct QuadraticEdge {
  std::array<base::NodeId, 3> nodes; ///< end, end, middle; the ends ascending
  std::int32_t elements = 0;         ///< how many share it
};

/// All edges of a mesh of elements that have modes, in the order of their first element.
struct EdgeTable {
  std::vector<QuadraticEdge> edges;
  std::vector<std::int32_t> first;   ///< [element + 1] into `of_side`
  std::vector<std::int32_t> of_side; ///< edges of all elements, side by side

  /// Index in `edges` of the edge at a side of an element.
  [[nodiscard]] std::size_t edge_at_side(base::ElementId e, int side) const {
    return static_cast<std::size_t>(of_side[static_cast<std::size_t>(first[e.index()] + side)]);
  }
};
/// Numbers the edges of a plane mesh of quadratic elements; edges are the same where all three
/// nodes are, so that the faces of a crack keep edges of their own.
EdgeTable make_edge_table(const model::Mesh& mesh);

/// 1 where a side runs from the lower to the higher of its corners, else -1: the sign of a side's
/// mode in the edge's.
inline double side_mode_sign(base::NodeId from, base::NodeId to) {
  return from < to ? 1.0 : -1.0;
}

} // namespace spricka::estimate
