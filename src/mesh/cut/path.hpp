// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "mesh/cut/cracked.hpp"
#include "mesh/cut/host.hpp"

#include <optional>
#include <vector>

namespace spricka::mesh {

/// The nodes of a crack along element edges from the mouth to the tip, mid nodes too; errors at
/// `span` if its PATH leaves the edges or the tip is not a corner node of it.
std::optional<std::vector<base::NodeId>> find_crack_path_nodes(const HostMesh& host,
                                                               const CrackLine& line,
                                                               base::SourceSpan span,
                                                               base::Diagnostics& diagnostics);

/// Whether the body lies on the left of a path along the boundary.
bool is_body_on_left(const HostMesh& host, base::NodeId from, base::NodeId to);

} // namespace spricka::mesh
