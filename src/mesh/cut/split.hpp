// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/cracked.hpp"

#include <optional>
#include <vector>

namespace spricka::mesh {

/// Opens a path of element edges: its nodes, all but the last one, the tip (of an embedded crack
/// the first one, too), are doubled, and the elements on the right of the path get the new ones.
/// `path` holds mid nodes too. Empty if the elements on both sides
/// hang together round a node of the path, as they do when it does not start on the boundary.
std::optional<CrackFaceNodes>
open_crack_along_path(model::Mesh& mesh, const std::vector<base::NodeId>& path, bool embedded);

/// Moves the mid nodes of all edges that leave a tip to their quarter points. Returns how many.
int make_quarter_point_edges(model::Mesh& mesh, base::NodeId tip);

/// Where the middle node of an edge at the tip lies, as a part of the edge from the tip: of the one
/// that is farthest from being a quarter point or a middle.
double worst_mid_node_position(const model::Mesh& mesh, base::NodeId tip);

} // namespace spricka::mesh
