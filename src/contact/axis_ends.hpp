// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"
#include "contact/node_pressure.hpp"
#include "contact/smooth.hpp"

#include <map>
#include <vector>

/// Nodal pressures next to the axis of axisymmetric bodies.
namespace spricka::contact {

/// Sets the pressures p [node] [stress] of chain ends next to the axis: on quadratic edges the
/// value there of a + b r^2 through the other two nodes (contact.14).
void extrapolate_pressure_to_axis(const ContactSurface& surface, const Numbering& number,
                                  base::Vector& p);

/// Copies state and gap of the mid node to a chain end next to the axis that has no row: in a NODE
/// pair the axis leaves such a corner no area.
void copy_mid_node_state_to_axis(const PairConstraints& pair,
                                 const std::map<base::NodeId, std::size_t>& row_of,
                                 std::vector<NodePressure>& nodes);

} // namespace spricka::contact
