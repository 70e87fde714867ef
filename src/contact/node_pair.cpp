// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/node_pair.hpp"

#include "contact/row_builder.hpp"

namespace spricka::contact {

namespace {

ConstraintRowBuilder between(const NodePair& nodes, const base::Vec3& along) {
  ConstraintRowBuilder row;
  row.add_contribution(nodes.node, -along);
  if (nodes.other.valid()) {
    row.add_contribution(nodes.other, along);
  }
  row.area = nodes.area;
  return row;
}

} // namespace

void append_node_rows(const NodePair& nodes, bool tangents, PairConstraints& pair) {
  ConstraintRowBuilder row = between(nodes, nodes.push);
  row.gap = nodes.area * nodes.gap;
  row.round_gap = row.gap;
  if (tangents) {
    const base::Vec3 along(-nodes.push.y(), nodes.push.x(), 0.0);
    pair.tangent.push_back(
        between(nodes, along).make_row(nodes.node, static_cast<int>(pair.normal.size())));
  }
  pair.normal.push_back(row.make_row(nodes.node));
}

} // namespace spricka::contact
