// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "model/forward.hpp"

namespace spricka::sense {

/// Warns of what supports take away before it can act: loads all of whose forces stand on held
/// freedoms (W457), contact surfaces in the plane and mouths of cracks whose nodes are all held
/// while the body behind them is not (W458).
void warn_of_loads_on_supports(const model::Model& model, base::Diagnostics& list);

/// Warns of a crack by PATH that does not begin where the boundary turns, so that its mouth is no
/// mouth (W459); a PATH with PATCH=NO that begins inside the body is refused (E458).
void warn_of_misplaced_crack_mouths(const model::Model& model, base::Diagnostics& list);

} // namespace spricka::sense
