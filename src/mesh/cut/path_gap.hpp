// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace spricka::mesh {

/// The first i for which no element edge holds both node i - 1 and node i of a path; empty when the
/// path runs along edges. Mid nodes may be in it or left out. In space every path passes.
std::optional<std::size_t> find_path_gap(const model::Mesh& mesh,
                                         const std::vector<base::NodeId>& path);

} // namespace spricka::mesh
