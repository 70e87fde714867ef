// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "model/forward.hpp"

namespace spricka::sense {

/// Warns of bodies that are drawn touching along sides with nothing between them: no contact, tie
/// or support (W451). In the plane the divisions of the two sides may differ, in space bodies of
/// two nets are seen that touch corner on corner. Work grows with the number of boundary sides.
void warn_of_unjoined_bodies(const model::Model& model, base::Diagnostics& list);

} // namespace spricka::sense
