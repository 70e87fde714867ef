// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/axis_ends.hpp"

#include <algorithm>

namespace spricka::contact {

namespace {

// Calls `mend(end, mid, next)` for the ends of chains next to the axis on quadratic edges. There
// the corner function's area, l r / 6, is next to nothing beside its first moment: force over area
// has no bound. The edge's other two nodes tell the pressure, which is even in r.
template <class Mend> void for_axis_ends(const ContactSurface& surface, Mend&& mend) {
  const auto look = [&](const Edge& edge, std::size_t end, std::size_t next) {
    const double reach = edge.x[next].x() - edge.x[end].x();
    if (edge.count == 3 && edge.x[end].x() < 0.5 * reach) {
      mend(edge, end, next);
    }
  };
  for (const EdgeChain& chain : surface.plane.chains) {
    if (!chain.closed) {
      look(surface.plane.edges_of_chain(chain).front(), 0, 1);
      look(surface.plane.edges_of_chain(chain).back(), 1, 0);
    }
  }
}

} // namespace

void extrapolate_pressure_to_axis(const ContactSurface& surface, const Numbering& number,
                                  base::Vector& p) {
  for_axis_ends(surface, [&](const Edge& edge, std::size_t end, std::size_t next) {
    const auto square = [&](std::size_t i) { return edge.x[i].x() * edge.x[i].x(); };
    const double p_mid = p[number.at(edge.nodes[2])];
    const double p_next = p[number.at(edge.nodes[next])];
    p[number.at(edge.nodes[end])] =
        p_mid + (p_mid - p_next) * (square(2) - square(end)) / (square(next) - square(2));
  });
}

void copy_mid_node_state_to_axis(const PairConstraints& pair,
                                 const std::map<base::NodeId, std::size_t>& row_of,
                                 std::vector<NodePressure>& nodes) {
  if (!pair.contact.axial || pair.segments) {
    return;
  }
  const auto at = [&](base::NodeId id) {
    return std::find_if(nodes.begin(), nodes.end(),
                        [&](const NodePressure& n) { return n.node == id; });
  };
  for_axis_ends(pair.contact, [&](const Edge& edge, std::size_t end, std::size_t) {
    if (!row_of.contains(edge.nodes[end])) {
      const auto neighbour = at(edge.nodes[2]);
      at(edge.nodes[end])->closed = neighbour->closed;
      at(edge.nodes[end])->gap = neighbour->gap;
    }
  });
}

} // namespace spricka::contact
