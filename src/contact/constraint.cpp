// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/constraint.hpp"

namespace spricka::contact {

std::map<base::NodeId, std::size_t> map_nodes_to_normal_rows(const PairConstraints& pair) {
  std::map<base::NodeId, std::size_t> row_of;
  for (std::size_t r = 0; r < pair.normal.size(); ++r) {
    row_of.emplace(pair.normal[r].node, r);
  }
  return row_of;
}

} // namespace spricka::contact
