// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/quality.hpp"
#include "mesh/tube/solid_net.hpp"

#include <vector>

namespace spricka::mesh {

/// Of these elements of a patch, ascending, those that are folded (mesh_faults), by their numbers
/// there.
std::vector<InvalidElement> folded_elements(const SolidPatchNet& net,
                                            const std::vector<std::size_t>& elements);

} // namespace spricka::mesh
