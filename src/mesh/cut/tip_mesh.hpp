// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/cracked.hpp"
#include "mesh/cut/host.hpp"
#include "model/forward.hpp"

#include <span>

namespace spricka::mesh {

/// Sizes where the deck is silent: from the crack's length and its last straight part, and the
/// distance of a tip to the nearest boundary (the ligament, a hole, a contact surface), to other
/// cracks in `all` and to earlier parts of its own. What the deck gives is taken as it is.
TipMeshParameters choose_tip_mesh(const HostMesh& host, const CrackLine& line,
                                  const model::TipMeshSettings* settings,
                                  std::span<const CrackLine> all = {});

} // namespace spricka::mesh
