// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/patch_net.hpp"
#include "mesh/quality.hpp"

#include <span>
#include <vector>

namespace spricka::mesh {

/// Of these elements of a patch, ascending, those that are folded (find_mesh_faults), by their
/// numbers there.
std::vector<InvalidElement> find_folded_elements(std::span<const PatchNode> nodes,
                                                 std::span<const PatchElement> elements,
                                                 const std::vector<std::size_t>& asked);

/// Of all elements of a patch.
std::vector<InvalidElement> find_folded_elements(std::span<const PatchNode> nodes,
                                                 std::span<const PatchElement> elements);

/// The one with the least determinant, the first of several; of at least one.
const InvalidElement& most_folded_element(const std::vector<InvalidElement>& folded);

} // namespace spricka::mesh
