// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"

#include <vector>

namespace spricka::mesh {

/// What sets of a mesh are for, by their numbers; an empty list: all are used.
struct SetUsage {
  std::vector<bool> nodes, elements, faces; ///< [set] something asks for it
  /// Whose nodes are held or moved: where they are those of edges, new nodes there are too.
  std::vector<base::NodeSetId> held;

  [[nodiscard]] static bool is_used(const std::vector<bool>& used, std::size_t set) {
    return used.empty() || (set < used.size() && used[set]);
  }
};

} // namespace spricka::mesh
