// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/cracked.hpp"
#include "mesh/node_elements.hpp"
#include "model/mesh.hpp"

#include <vector>

/// Which elements stand round a front, layer by layer.
namespace spricka::crack {

/// Nodes of the front beside its points: the mid nodes between them, and whether the last point is
/// joined to the first.
struct FrontMidNodes {
  std::vector<base::NodeId> middle; ///< [point] between it and the next one; invalid: none
  bool closed = false;
};
/// Finds the mid nodes of the element edges between neighbouring points of a front; a front of
/// fewer than three points cannot be closed.
FrontMidNodes front_mid_nodes(const model::Mesh& mesh, const mesh::NodeToElementsMap& elements,
                              const mesh::CrackFront& front);

/// Layers of elements by nodes in common, the first those that have a node of the front.
struct ElementLayersRoundFront {
  std::vector<std::vector<base::ElementId>> elements; ///< [layer - 1], ascending
  std::vector<int> of_node; ///< [node] the layer that it came with, 0 on the front; -1: none

  /// How much of the extension of a corner node: 1 up to a layer, 0 beyond.
  [[nodiscard]] double extension_factor(base::NodeId n, int rings) const {
    const int layer = of_node[n.index()];
    return layer >= 0 && layer <= rings ? 1.0 : 0.0;
  }
};
/// The first `count` layers of elements round a front, found from its points and the mid nodes of
/// `line` outward.
ElementLayersRoundFront find_layers_round_front(const model::Mesh& mesh,
                                                const mesh::NodeToElementsMap& elements,
                                                const mesh::CrackFront& front,
                                                const FrontMidNodes& line, int count);

/// Sides of these elements that belong to the body's surface or to faces of cracks, ascending:
/// those of one element only, but for quadrilaterals on which two triangles of other elements lie.
std::vector<model::Face> free_sides(const model::Mesh& mesh,
                                    const std::vector<base::ElementId>& elements);

} // namespace spricka::crack
