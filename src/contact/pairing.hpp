// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "contact/constraint.hpp"
#include "model/forward.hpp"

#include <vector>

/// From two surfaces to the constraint rows between them.
namespace spricka::contact {

/// Builds the rows of a pair on a mesh. SEGMENT: mortar with hat functions on half edges, weighted
/// by exact segment integration (Puso and Laursen 2004 in the plane); the multipliers are
/// non-negative functions that contain constants. NODE: nodes that lie opposite each other.
/// Declared gaps replace the measured ones; normals are radial on circles, and those of the target
/// where that is rigid: there the slave carries the multipliers, and the rows are exact.
PairConstraints build_pair_constraints(const model::Model& model, const model::Mesh& mesh,
                                       const model::Contact& contact);

/// The same on a mesh some nodes of which have been moved a little [node] since the rows of `pair`
/// were built: rows of faces between nodes at rest, and places where a surface ends, are taken from
/// there, and so is the side that carries the multipliers.
PairConstraints build_moved_pair_constraints(const model::Model& model, const model::Mesh& mesh,
                                             const model::Contact& contact,
                                             const PairConstraints& pair,
                                             const std::vector<bool>& moved);

/// Nodes of both surfaces of a pair: their freedoms must be external.
std::vector<base::NodeId> pair_surface_nodes(const model::Mesh& mesh,
                                             const model::Contact& contact);

} // namespace spricka::contact
