// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <string>

namespace spricka::results {

/// What the loads of one case come to with factor 1, in the mesh of the first length.
struct LoadTotal {
  std::string load_case;
  base::Vec3 force = base::Vec3::Zero();  ///< [force]; about an axis: of the whole circumference
  base::Vec3 moment = base::Vec3::Zero(); ///< about the origin [force * length]
  double magnitude_sum = 0.0;             ///< sum of the nodal forces' magnitudes [force]
};

} // namespace spricka::results
