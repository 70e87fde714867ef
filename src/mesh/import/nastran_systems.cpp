// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/nastran_systems.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace spricka::mesh {
namespace {

/// Coordinates of a cylindrical (r, theta, z) or spherical (r, theta from the z axis, phi) system
/// along its axes.
base::Vec3 along_axes(char kind, const base::Vec3& at) {
  constexpr double degree = std::numbers::pi / 180.0;
  const double a = at.y() * degree;
  const double b = at.z() * degree;
  switch (kind) {
  case 'C':
    return {at.x() * std::cos(a), at.x() * std::sin(a), at.z()};
  case 'S':
    return {at.x() * std::sin(a) * std::cos(b), at.x() * std::sin(a) * std::sin(b),
            at.x() * std::cos(a)};
  default:
    return at;
  }
}

} // namespace

bool NastranSystems::find_basic(base::Label system, const base::Vec3& at, base::Vec3& basic,
                                std::string& trouble) {
  if (system == 0) {
    basic = at;
    return true;
  }
  const BasicFrame& found = frame(system);
  if (!found.trouble.empty()) {
    trouble = found.trouble;
    return false;
  }
  basic = found.origin + found.axes * along_axes(bulk_.systems.at(system).kind, at);
  return true;
}

const NastranSystems::BasicFrame& NastranSystems::frame(base::Label label) {
  const auto [at, fresh] = frames_.try_emplace(label);
  BasicFrame& frame = at->second;
  if (!fresh) {
    return frame;
  }
  const auto system = bulk_.systems.find(label);
  if (system == bulk_.systems.end()) {
    const auto other = bulk_.other_systems.find(label);
    frame.trouble =
        other == bulk_.other_systems.end()
            ? "is not there"
            : fmt::format("is a {}, by nodes: CORD2R, CORD2C and CORD2S are read", other->second);
    return frame;
  }
  frame.trouble = "is defined by itself"; // while those that it is defined in are looked up
  std::array<base::Vec3, 3> points{};
  for (std::size_t p = 0; p < 3; ++p) {
    std::string trouble;
    if (!find_basic(system->second.reference, system->second.points[p], points[p], trouble)) {
      frame.trouble =
          fmt::format("is defined in system {}, which {}", system->second.reference, trouble);
      return frame;
    }
  }
  const base::Vec3 z = points[1] - points[0];
  const base::Vec3 y = z.cross(points[2] - points[0]);
  if (!(y.norm() > 1e-12 * z.norm() * (points[2] - points[0]).norm())) {
    frame.trouble = "has points that give no axes";
    return frame;
  }
  frame.trouble.clear();
  frame.origin = points[0];
  frame.axes.col(2) = z.normalized();
  frame.axes.col(1) = y.normalized();
  frame.axes.col(0) = frame.axes.col(1).cross(frame.axes.col(2));
  return frame;
}

} // namespace spricka::mesh
