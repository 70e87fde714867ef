// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cracks.hpp"

#include <Eigen/Geometry>

namespace spricka::model {

base::Vec3 PlanarCrack::transverse_axis() const {
  return normal.cross(along);
}

} // namespace spricka::model
