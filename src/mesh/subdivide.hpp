// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <vector>

namespace spricka::mesh {

/// Divides every plane element of the nets marked (`nets` [net]) into four of its own type, by its
/// own map: edges that were curved stay so, and both sides of an edge agree. Nodes keep their
/// numbers and places; new ones follow, with labels above the highest of their net. The first
/// quarter of an element keeps its number and label. Sets go along: an element set takes all four
/// quarters, a face set both halves of a side, a node set the new nodes of edges and elements whose
/// nodes are all in it, between those of an edge where they stand one after another (a path stays
/// one). Elements in space are left as they are.
void subdivide_plane_elements(model::Mesh& mesh, const std::vector<bool>& nets);

} // namespace spricka::mesh
