// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/node_pair.hpp"

#include "contact/row_builder.hpp"

namespace spricka::contact {

void append_node_rows(const NodePair& nodes, PairConstraints& pair) {
  const auto normal = static_cast<int>(pair.normal.size());
  for (std::size_t k = 0; k < nodes.push.size(); ++k) {
    ConstraintRowBuilder row;
    row.add_contribution(nodes.node, -nodes.push[k]);
    if (nodes.other.valid()) {
      row.add_contribution(nodes.other, nodes.push[k]);
    }
    row.area = nodes.area;
    if (k > 0) {
      pair.tangent.push_back(row.make_row(nodes.node, normal));
      continue;
    }
    row.gap = nodes.area * nodes.gap;
    row.round_gap = row.gap;
    pair.normal.push_back(row.make_row(nodes.node));
  }
}

} // namespace spricka::contact
