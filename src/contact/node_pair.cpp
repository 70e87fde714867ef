// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/node_pair.hpp"

#include "contact/row_builder.hpp"

namespace spricka::contact {

namespace {

RowBuilder between(const NodePair& nodes, const base::Vec3& along) {
  RowBuilder row;
  row.add(nodes.node, -along);
  if (nodes.other.valid()) {
    row.add(nodes.other, along);
  }
  row.area = nodes.area;
  return row;
}

} // namespace

void add_rows(const NodePair& nodes, bool tangents, PairRows& pair) {
  RowBuilder row = between(nodes, nodes.push);
  row.gap = nodes.area * nodes.gap;
  row.round_gap = row.gap;
  if (tangents) {
    const base::Vec3 along(-nodes.push.y(), nodes.push.x(), 0.0);
    pair.tangent.push_back(
        between(nodes, along).finish(nodes.node, static_cast<int>(pair.normal.size())));
  }
  pair.normal.push_back(row.finish(nodes.node));
}

} // namespace spricka::contact
