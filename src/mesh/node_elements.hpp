// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace spricka::mesh {

/// The elements that have each node, ascending.
class NodeToElementsMap {
public:
  explicit NodeToElementsMap(const model::Mesh& mesh);

  /// Elements that have a node, ascending; empty for a node of none.
  [[nodiscard]] std::span<const base::ElementId> elements_around(base::NodeId node) const {
    return std::span(elements_).subspan(start_[node.index()],
                                        start_[node.index() + 1] - start_[node.index()]);
  }

private:
  std::vector<std::size_t> start_; ///< [node + 1] into elements_
  std::vector<base::ElementId> elements_;
};

} // namespace spricka::mesh
