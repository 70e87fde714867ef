// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <span>

namespace spricka::mesh {

/// Four quadratic triangles with a corner in the middle of a quadrilateral of eight or nine nodes
/// take its place on the other side of a join. Their nodes that it has not follow its own: the
/// middle (where it has no node there), then, for each corner, the place half way from there to the
/// middle. Returns the weights [such nodes, nodes of the quadrilateral] for which the displacements
/// of both sides have the same integral times 1, x and y over the quadrilateral as seen along its
/// normal: tractions that are linear then do the same work on both, so that hexahedra and
/// tetrahedra pass the patch test of a linear stress. Of all such weights those that differ least
/// from the shape functions; of displacements that are quadratic these are exact, and stay so.
/// `nodes`: corners in order, middles of the edges after them, and the middle (any unit of length).
base::Matrix quadrilateral_tie_weights(std::span<const base::Vec3> nodes);

} // namespace spricka::mesh
