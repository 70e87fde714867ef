// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene/supported_rows.hpp"

#include <algorithm>
#include <set>

namespace spricka::analysis {

namespace {

// Between solids there is no slip where supports, as those of a symmetry plane, hold a node of the
// contact side and the target before it in one direction: a row of friction or of a bond in it
// would press across the plane.
void drop_held_slips(contact::PairConstraints& pair, const std::vector<model::FreedomRole>& cls) {
  constexpr double most = 0.7; // of a row's weight, squared: a surface turns on to one side
  std::set<base::NodeId> own;
  for (const geometry::ElementSide& face : pair.contact.facets) {
    own.insert(face.nodes.begin(), face.nodes.end());
  }
  const auto is_held = [&](const contact::RowEntry& entry) {
    double held = 0.0;
    for (int c = 0; c < 3; ++c) {
      const std::size_t freedom = 3 * entry.node.index() + static_cast<std::size_t>(c);
      held += model::is_suppressed_or_prescribed(cls[freedom]) ? entry.weight[c] * entry.weight[c]
                                                               : 0.0;
    }
    return held >= most * entry.weight.squaredNorm();
  };
  std::erase_if(pair.tangent, [&](const contact::ConstraintRow& row) {
    const auto node = std::ranges::find(row.entries, row.node, &contact::RowEntry::node);
    return node != row.entries.end() && is_held(*node) &&
           (pair.rigid || std::ranges::any_of(row.entries, [&](const contact::RowEntry& entry) {
              return !own.contains(entry.node) && is_held(entry);
            }));
  });
}

// Where a support holds a node along an axis the surface may end at a plane of symmetry, across
// which the pressure has no slope.
void mark_held_functions(contact::PairConstraints& pair,
                         const std::vector<model::FreedomRole>& cls) {
  for (contact::MultiplierFunction& function : pair.functions) {
    for (std::size_t c = 0; c < function.held.size(); ++c) {
      function.held[c] = model::is_suppressed_or_prescribed(cls[3 * function.node.index() + c]);
    }
  }
}

} // namespace

void apply_supports_to_rows(contact::PairConstraints& pair,
                            const std::vector<model::FreedomRole>& cls) {
  drop_held_slips(pair, cls);
  mark_held_functions(pair, cls);
}

std::vector<base::NodeId> find_nodes_in_pair_rows(const contact::PairConstraints& pair) {
  std::set<base::NodeId> nodes;
  for (const auto* rows : {&pair.normal, &pair.tangent}) {
    for (const contact::ConstraintRow& row : *rows) {
      for (const contact::RowEntry& entry : row.entries) {
        nodes.insert(entry.node);
      }
    }
  }
  return {nodes.begin(), nodes.end()};
}

} // namespace spricka::analysis
