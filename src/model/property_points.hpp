// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <cstdint>
#include <vector>

namespace spricka::model {

/// Where a field that jumps between properties has one value: at every node, and once more for each
/// further property that meets there. (Crack faces have nodes of their own already.)
struct FieldPointsByProperty {
  std::vector<std::int32_t> of; ///< [connectivity index] point
  /// [point]; the first are the nodes themselves, each with the property that comes first there
  std::vector<base::NodeId> node;
};

/// Numbers the points of a mesh by its elements in their order; a node without an element has one
/// too.
FieldPointsByProperty property_points(const Mesh& mesh);

} // namespace spricka::model
