// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "mesh/cut/cracked.hpp"
#include "mesh/tube/solid_crack.hpp"
#include "mesh/tube/solid_host.hpp"

#include <optional>
#include <span>

namespace spricka::mesh {

/// Cuts plane cracks into a mesh of solids, of whatever elements. Cracks that cannot be placed are
/// reported at the crack's card (`span[i]`) and give an empty result. Round each front runs a tube
/// of quarter-point elements, the rest of the patch are tetrahedra of ten nodes, tied where they
/// meet quadrilaterals or linear elements (`ties`). Patches are meshed in the crack's frame,
/// coordinates divided by its size and rounded (to 2^-26, for the choice of elements only), so that
/// units and position do not change the mesh. Always cuts from the host.
std::optional<CrackedMesh> insert_solid_cracks(const SolidHostMesh& host,
                                               std::span<const SolidCrack> cracks,
                                               std::span<const TubeMeshParameters> tubes,
                                               std::span<const base::SourceSpan> spans,
                                               base::Diagnostics& diagnostics);

} // namespace spricka::mesh
