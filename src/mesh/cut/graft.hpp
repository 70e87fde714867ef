// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/cracked.hpp"
#include "mesh/cut/patch_net.hpp"

#include <functional>
#include <span>
#include <vector>

/// Patches put into the host, and the sides of elements at the cracks of the mesh that comes of it.
namespace spricka::mesh {

/// A patch ready to be put into the host.
struct PatchGraft {
  const Patch& patch;
  const std::vector<base::ElementId>& removed; ///< elements of the host that it replaces, ascending
  /// The one of them that a new element lies in, by the middle of its corners: that element's
  /// property and sets it takes over.
  std::function<base::ElementId(const PatchNode& middle)> parent;
};

/// Where nodes and elements of a patch are in the mesh it was put into.
struct GraftedPatch {
  std::vector<base::NodeId> node;       ///< [patch node]
  std::vector<base::ElementId> element; ///< [patch element]

  [[nodiscard]] base::NodeId node_in_mesh(int n) const { return node[static_cast<std::size_t>(n)]; }
};

/// A host of plane or solid elements with its cavities filled.
struct GraftedMesh {
  CrackedMesh cracked; ///< mesh, `host`, `unreplaced_set_nodes` and all sets
  std::vector<GraftedPatch> patches;
};
GraftedMesh graft_patches(const model::Mesh& host, std::span<const PatchGraft> grafts);

/// Adds the ties of a patch to the mesh that it was put into, in the name of a crack.
void add_patch_ties(const Patch& patch, const GraftedPatch& placed, base::CrackId crack,
                    CrackedMesh& cracked);

/// The faces of a crack, in the plane from the mouth (or first tip) to the tip; one side is empty
/// where the crack lies on a symmetry line.
struct CrackFaceSides {
  std::vector<model::Face> left, right;
};
CrackFaceSides crack_face_sides(const model::Mesh& mesh, const CrackFaceNodes& crack_faces);

} // namespace spricka::mesh
