// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <vector>

namespace spricka::mesh {

/// An element that must not be used: its Jacobian determinant is not positive at an integration
/// point, negative at a node of a plane element, or at a node of a solid by more than a tenth
/// of its mean. (The tip node of a quarter-point element, where it is zero by intent, is left out.)
struct InvalidElement {
  base::ElementId element;
  double jacobian = 0.0;              ///< the smallest determinant met
  base::Vec3 at = base::Vec3::Zero(); ///< where
  bool turned = false; ///< negative at all points met: the nodes run the wrong way round
};

/// A solid whose determinant is negative at a node, by less than a tenth of its mean, and
/// positive at all integration points: its stiffness is sound, its map is not one to one in that
/// corner.
struct FoldedCorner {
  base::ElementId element;
  base::NodeId node;
  double part = 0.0; ///< determinant at the node over the mean, -0.1 to 0
};

struct MeshFaults {
  std::vector<InvalidElement> bad;   ///< ascending
  std::vector<FoldedCorner> corners; ///< ascending; of several in an element the worst
};

/// Looks at every element. Zero determinants at single nodes of quarter-point or collapsed elements
/// are accepted.
MeshFaults find_mesh_faults(const model::Mesh& mesh);

/// Elements that cannot be computed with, ascending: find_mesh_faults without the folded corners.
std::vector<InvalidElement> find_invalid_elements(const model::Mesh& mesh);

} // namespace spricka::mesh
