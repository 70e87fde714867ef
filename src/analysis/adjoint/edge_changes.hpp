// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

namespace spricka::analysis {

/// By how much K along fronts changes where contact ends a row of nodes further on or back (manual,
/// estimate.25). [K]
struct EdgeChanges {
  base::Vector ends; ///< the largest, of the edges of what is closed
  base::Vector
      sharp; ///< sum over edges of bodies on the faces of cracks that contact is closed up to
};

} // namespace spricka::analysis
