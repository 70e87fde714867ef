// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace spricka::report {

/// Nodes of the node or element set of that name, ascending, each once; empty without such a set.
std::vector<base::NodeId> set_members(const model::Mesh& mesh, std::string_view name);

/// Where the stresses of a set stand in the results (model/property_points.hpp), node by node: of
/// an element set those of its own elements' properties, of a node set all.
struct StressPoint {
  base::NodeId node;
  std::size_t point = 0;
};
/// The stress points of the sets of that name, ascending by node; empty without such a set.
std::vector<StressPoint> stress_points(const model::Mesh& mesh, std::string_view name);

} // namespace spricka::report
