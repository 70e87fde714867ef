// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

namespace spricka::analysis {

/// By how much K along fronts changes where contact ends a row of nodes further on or back (manual,
/// estimate.25). [K]
struct ContactEdgeKChange {
  /// The largest, of the edges of what is closed.
  base::Vector ends;
  /// Sum over edges of bodies on the faces of cracks, where contact is closed up to them.
  base::Vector sharp;
};

} // namespace spricka::analysis
