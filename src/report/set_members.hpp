// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <string_view>
#include <vector>

namespace spricka::report {

/// Nodes of the node or element set of that name, ascending, each once; empty without such a set.
std::vector<base::NodeId> set_members(const model::Mesh& mesh, std::string_view name);

} // namespace spricka::report
