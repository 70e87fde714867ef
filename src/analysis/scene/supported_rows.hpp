// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"
#include "model/freedoms.hpp"

#include <vector>

/// What supports make of the rows between solids.
namespace spricka::analysis {

/// Leaves out slips that supports hold and notes which functions they hold. cls [3 * node].
void apply_supports_to_rows(contact::PairConstraints& pair,
                            const std::vector<model::FreedomRole>& cls);

/// Nodes whose freedoms the rows of a pair weigh, ascending.
std::vector<base::NodeId> find_nodes_in_pair_rows(const contact::PairConstraints& pair);

} // namespace spricka::analysis
