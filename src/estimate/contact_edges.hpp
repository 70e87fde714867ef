// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"
#include "estimate/edges.hpp"

#include <array>
#include <map>
#include <optional>
#include <vector>

namespace spricka::estimate {

/// An edge of a contact surface in the edge table, and what lies opposite.
struct ContactEdge {
  std::size_t edge = 0;
  const contact::Edge* shape = nullptr; ///< in the pair
  std::vector<std::size_t> rows; ///< normal rows of the pair that decide whether it is closed
  /// The edge of the other surface that lies exactly opposite, and 1 where both run (from the lower
  /// to the higher of their ends) the same way, else -1; only given on the contact side.
  std::optional<std::size_t> opposite;
  double same_way = 1.0;
  bool target_side = false;
  bool covered = false; ///< faces the other surface along its whole length
};

/// Edges of one element only, by their nodes.
using EdgeIndex = std::map<std::array<base::NodeId, 3>, std::size_t>;
/// Index of the edges that only one element has, by their three nodes as in the table.
EdgeIndex index_boundary_edges(const EdgeTable& table);
/// The one that a quadratic contact edge is.
std::optional<std::size_t> find_mesh_edge(const EdgeIndex& index, const contact::Edge& edge);

/// The edges of both surfaces of a pair, which they point into. Edges that match end to end to a
/// hundredth of their length are opposite each other.
std::vector<ContactEdge> contact_edges_of_pair(const EdgeTable& table,
                                               const contact::PairConstraints& pair);

/// A closed edge: all its rows are.
struct ClosedContactEdge {
  const ContactEdge* at = nullptr;
  bool bonded = false;
  double support = 0.0; ///< stiffness of the other body over that of the edge's own
  bool loaded = false;  ///< the mode of a target edge with none opposite carries the pressure
};
/// closed [normal row of the pair], bonded: all of them; appended to `result`, which keeps pointers
/// into `edges`.
void add_closed_edges(const std::vector<ContactEdge>& edges, const contact::PairConstraints& pair,
                      const std::vector<bool>& closed, bool bonded,
                      std::vector<ClosedContactEdge>& result);

} // namespace spricka::estimate
