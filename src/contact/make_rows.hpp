// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/pair_points.hpp"
#include "contact/row_builder.hpp"

#include <array>
#include <map>
#include <span>
#include <vector>

/// From integration points to constraint rows, whatever the dimension.
namespace spricka::contact {

/// The rows of one node while they are summed: across the surfaces and along them.
struct NodalRowSums {
  ConstraintRowBuilder normal;
  std::array<ConstraintRowBuilder, 2> tangent;
};
using RowsByNode = std::map<base::NodeId, NodalRowSums>;

/// Weights the motion of the two surfaces at each point by the hats of the contact facet, node by
/// node. `targets` is empty where the target is rigid; `tangents`: how many of the points' tangents
/// make rows as well.
RowsByNode integrate_mortar_rows(const MortarPoints& points,
                                 std::span<const geometry::ElementSide> contact,
                                 std::span<const geometry::ElementSide> targets, int tangents);

/// The nodes of a contact surface in the order in which rows are merged and stand; after the last
/// the first one follows where it is closed.
struct NodeOrder {
  std::vector<base::NodeId> nodes;
  bool closed = false;
};

/// A sliver of cover, less than a fifth of its function's whole area, makes a row that weighs next
/// to nothing: its function joins a neighbour's. How many did.
int merge_slivers(const NodeOrder& order, RowsByNode& rows);

/// Appends the rows that weigh something to those of a pair, in order; tangent rows behind one
/// another know their normal row.
void append_rows(const NodeOrder& order, const RowsByNode& rows, int tangents,
                 PairConstraints& pair);

} // namespace spricka::contact
