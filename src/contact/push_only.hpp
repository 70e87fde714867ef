// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"
#include "contact/node_pressure.hpp"
#include "contact/smooth.hpp"

#include <cstddef>
#include <vector>

/// What nodal pressures of a contact that only pushes must obey, and their mean.
namespace spricka::contact {

/// The nodes of one chain within a list of all nodes of a surface, chain by chain.
struct ChainRange {
  std::size_t first = 0, count = 0;
  bool closed = false;
};
std::vector<ChainRange> node_ranges_of_chains(const ContactSurface& surface);

/// Nodal pressures with the shear beside them [node, as numbered]; no shear: empty.
struct NodalPressuresAndShears {
  base::Vector& p;
  base::Vector& q;
};

/// Makes p >= 0 and keeps sum area * p and sum area * q of each chain (contact.24): what a node
/// pulls is taken from the nearest nodes of its chain that push, and its shear goes with it, so
/// that a ratio q / p that all nodes have stays. `order` [node]: chain by chain.
void redistribute_tension(const ContactSurface& surface, const std::vector<Eigen::Index>& order,
                          const base::Vector& area, NodalPressuresAndShears traction);

/// Area of the part in contact: closed rows, up to where the square-root law (contact.11) ends the
/// pressure behind the last of them. Nodes as recover_pressure has them.
double contact_area(const PairConstraints& pair, const std::vector<NodePressure>& nodes);

} // namespace spricka::contact
