// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/vec.hpp"
#include "geometry/box_tree.hpp"
#include "model/mesh.hpp"

#include <vector>

namespace spricka::fe {

/// A mesh that stands in the place of another, the host, of which cracks took some elements. All
/// must outlive it; `host` may be null, then the mesh is its own host.
struct PatchedMesh {
  const model::Mesh& mesh;
  const model::Mesh& host_mesh;
  const std::vector<base::ElementId>* host = nullptr; ///< [element] invalid: of a patch
  std::vector<base::NodeId> front_nodes;              ///< where gradients may be singular

  /// Whether an element belongs to a patch round a crack, so that the host has none of it.
  [[nodiscard]] bool is_patch_element(base::ElementId e) const {
    return host != nullptr && !(*host)[e.index()].valid();
  }
};

/// Finds the element that the host had at a place, among those that were taken.
class HostElementFinder {
public:
  explicit HostElementFinder(const PatchedMesh& patched);
  /// Elements of the host that the mesh does not have, ascending.
  [[nodiscard]] const std::vector<base::ElementId>& removed_elements() const { return taken_; }
  /// The one that x lies in, or comes nearest to; invalid where nothing was taken.
  [[nodiscard]] base::ElementId at(const base::Vec2& x) const;

private:
  std::vector<base::ElementId> taken_;
  /// [taken] points in order round it; curved sides in pieces
  std::vector<std::vector<base::Vec2>> outlines_;
  geometry::BoxTree<2> boxes_; ///< [taken]
};

} // namespace spricka::fe
