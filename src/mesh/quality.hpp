// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <vector>

namespace spricka::mesh {

/// An element whose Jacobian determinant is not positive at an integration point or a node (the
/// tip node of a quarter-point element, where it is zero by intent, is left out).
struct BadElement {
  base::ElementId element;
  double jacobian = 0.0;              ///< the smallest determinant met
  base::Vec3 at = base::Vec3::Zero(); ///< where
  bool turned = false; ///< negative at all points met: the nodes run the wrong way round
};

/// All bad elements, ascending. Zero determinants at single nodes of quarter-point or collapsed
/// elements are accepted; negative ones nowhere.
std::vector<BadElement> bad_elements(const model::Mesh& mesh);

} // namespace spricka::mesh
