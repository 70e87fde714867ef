// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/host.hpp"
#include "mesh/cut/placement.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace spricka::mesh {

/// An edge of a cavity, cavity on the left.
struct CavityOutlineEdge {
  model::Face face; ///< of the host element inside the cavity
  EdgeEndAndMidNodes edge;
  bool free = false; ///< on the host's boundary; else elements that stay lie beyond
};

/// The host elements that a patch replaces, ascending, and the closed loops that bound them.
struct Cavity {
  std::vector<base::ElementId> elements;
  std::vector<std::vector<CavityOutlineEdge>> loops;
};

/// Elements that cracks and rosettes touch or come near, and as much as one layer more: connected
/// cavities of one property without pinched nodes. Cavities share no element: where they would, the
/// layers give way; cracks too near to each other for that have one cavity together.
struct Cavities {
  std::vector<Cavity> each;
  std::vector<std::vector<std::size_t>> cracks; ///< [cavity] numbers of its placements, ascending
};
Cavities find_cavities(const HostMesh& host, std::span<const CrackPlacement> placements);

/// Whether an edge is longer than its room, times `part`: its distance from the crack and from the
/// rosettes.
bool is_edge_longer_than_clearance(const model::Mesh& mesh, const CrackPlacement& placement,
                                   const EdgeEndAndMidNodes& edge, double part);

} // namespace spricka::mesh
