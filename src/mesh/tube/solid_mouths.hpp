// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/tube/laid_crack.hpp"
#include "mesh/tube/solid_front.hpp"

namespace spricka::mesh {

/// Divides the mouths of a crack between the ends of its tubes; false, with an error, where they
/// cannot be followed.
bool divide_crack_mouths(const SolidHostMesh& host, const CrackFrame& frame,
                         const LocatedSolidCrack& request, PatchSolidCrack& crack,
                         base::Diagnostics& diagnostics);

} // namespace spricka::mesh
