// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/cracked.hpp"
#include "mesh/cut/host.hpp"

#include <span>
#include <vector>

namespace spricka::mesh {

/// Host elements that the cavity of any of these lines may touch, with a margin of one layer of
/// elements: the region that is condensed anew at each length. Ascending.
std::vector<base::ElementId> possible_cavity_elements(const HostMesh& host,
                                                      std::span<const CrackLine> lines,
                                                      std::span<const TipMeshParameters> tips);

} // namespace spricka::mesh
