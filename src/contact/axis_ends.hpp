// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"
#include "contact/node_pressure.hpp"
#include "contact/smooth.hpp"

#include <map>
#include <vector>

/// What nodal pressures need next to the axis of bodies about it.
namespace spricka::contact {

/// Pressures of the ends of chains next to the axis, on quadratic edges (contact.14).
void mend_axis_ends(const Surface& surface, const Numbering& number, base::Vector& p);

/// A NODE pair has no row where the axis leaves a corner no area: the node does as its neighbour.
void copy_to_axis_ends(const PairRows& pair, const std::map<base::NodeId, std::size_t>& row_of,
                       std::vector<NodePressure>& nodes);

} // namespace spricka::contact
