// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <map>
#include <span>
#include <vector>

namespace spricka::mesh {

/// Finds sides of elements by their corner nodes, in whatever order these are given.
class SideIndex {
public:
  /// Sides of the elements from `first` on.
  explicit SideIndex(const model::Mesh& mesh, std::size_t first = 0);

  /// The sides with these corners: none, one on the boundary, two between elements.
  [[nodiscard]] std::span<const model::Face> find(std::vector<base::NodeId> corners) const;

private:
  std::map<std::vector<base::NodeId>, std::vector<model::Face>> sides_;
};

} // namespace spricka::mesh
