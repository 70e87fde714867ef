// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "mesh/cut/cracked.hpp"
#include "mesh/cut/host.hpp"

#include <optional>
#include <span>

namespace spricka::mesh {

/// Cuts the cracks into the host. Cracks that cannot be placed (touch no element, leave the body,
/// cross a material boundary) are reported at the crack's card (`span[i]`) and give an empty
/// result. Patches are meshed in the crack's frame, coordinates divided by a and rounded (to 2^-26,
/// for the choice of elements only), so that units and position do not change the mesh. Always cuts
/// from the host.
std::optional<CrackedMesh> insert_cracks(const HostMesh& host, std::span<const CrackLine> lines,
                                         std::span<const TipMeshParameters> parameters,
                                         std::span<const base::SourceSpan> spans,
                                         base::Diagnostics& diagnostics);

} // namespace spricka::mesh
