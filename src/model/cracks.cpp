// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cracks.hpp"

#include <cmath>

#include <Eigen/Geometry>

namespace spricka::model {

base::Vec3 PlanarCrack::transverse_axis() const {
  return normal.cross(along);
}

base::Vec3 PlanarCrack::ellipse_point(double phi) const {
  return place + c * std::cos(phi) * along + a * std::sin(phi) * transverse_axis();
}

} // namespace spricka::model
