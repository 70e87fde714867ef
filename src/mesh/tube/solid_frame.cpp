// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/solid_frame.hpp"

#include "geometry/polyline.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace spricka::mesh {

using base::Vec3;

std::shared_ptr<const NonPlanarCrackSurface> crack_surface_in_frame(const CrackFrame& frame,
                                                                    const SolidCrack& crack) {
  if (!crack.relief) {
    return nullptr;
  }
  return std::make_shared<const NonPlanarCrackSurface>(
      crack.relief->transformed([&](const Vec3& x) { return frame.exact_local_coordinates(x); },
                                [&](const Vec3& d) -> Vec3 { return frame.axes.transpose() * d; }));
}

CrackFrame make_crack_frame(const SolidCrack& crack) {
  const std::vector<Vec3>& x = crack.front;
  const double length = geometry::polyline_length(x);
  // Fan of triangles from the first point: area and middle of what the front encloses.
  double area = 0.0;
  Vec3 moment = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < x.size(); ++i) {
    const double part = 0.5 * (x[i] - x[0]).cross(x[i + 1] - x[0]).dot(crack.normal);
    area += part;
    moment += part / 3.0 * (x[i] + x[i + 1] - 2.0 * x[0]);
  }
  CrackFrame frame;
  const double radius = std::sqrt(std::abs(area) / std::numbers::pi);
  const bool thin = radius < 0.02 * length; // of a straight front
  frame.a = thin ? 0.25 * length : radius;
  frame.origin = thin ? Vec3(0.5 * (x.front() + x.back())) : Vec3(x[0] + moment / area);
  const Vec3 ahead = x[0] - frame.origin;
  const Vec3 e1 = (ahead - crack.normal.dot(ahead) * crack.normal).normalized();
  frame.axes.col(0) = e1;
  frame.axes.col(1) = crack.normal.cross(e1);
  frame.axes.col(2) = crack.normal;
  return frame;
}

} // namespace spricka::mesh
