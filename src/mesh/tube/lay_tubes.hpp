// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/tube/laid_crack.hpp"
#include "mesh/tube/solid_front.hpp"

#include <optional>
#include <span>

namespace spricka::mesh {

/// The crack with its tubes in a frame; empty, with an error, where a tube does not fit.
std::optional<PatchSolidCrack> lay_tubes(const SolidHost& host, const SolidFrame& frame,
                                         const SolidRequest& request,
                                         std::span<const SolidRequest> all,
                                         base::Diagnostics& diagnostics);

} // namespace spricka::mesh
