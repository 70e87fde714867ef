// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/tube/laid_crack.hpp"
#include "mesh/tube/solid_front.hpp"

#include <optional>
#include <span>

namespace spricka::mesh {

/// The crack with its tubes in a frame; empty, with an error, where a tube does not fit.
std::optional<PatchSolidCrack> place_tubes(const SolidHostMesh& host, const CrackFrame& frame,
                                           const LocatedSolidCrack& request,
                                           std::span<const LocatedSolidCrack> all,
                                           base::Diagnostics& diagnostics);

} // namespace spricka::mesh
