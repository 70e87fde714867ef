// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/turned_front.hpp"

#include "geometry/polyline.hpp"

#include <algorithm>

#include <Eigen/Geometry>

namespace spricka::growth {

namespace {

using base::Vec3;

constexpr int pieces = 120; // of a front
/// Parts of a front's length that an open one goes straight on by at its ends.
constexpr double little = 0.03;
constexpr double far = 0.3;
/// An advance that is less than this part of the largest one has no direction of its own.
constexpr double hardly = 0.02;

// Of an open front with two points more at either end, which lie outside of the body.
std::vector<Vec3> line_of(const mesh::FrontCurve& front) {
  std::vector<Vec3> line;
  const double length = front.length();
  const auto beyond = [&](double part) {
    if (!front.closed()) {
      line.push_back(front.at(part * length).x);
    }
  };
  beyond(-far);
  beyond(-little);
  for (int i = 0; i < pieces + (front.closed() ? 0 : 1); ++i) {
    line.push_back(front.at(length * i / pieces).x);
  }
  beyond(1.0 + little);
  beyond(1.0 + far);
  if (front.closed()) {
    line.push_back(line.front());
  }
  return line;
}

} // namespace

std::vector<Vec3> crack_normals(const model::CrackDefinition& crack,
                                const std::vector<Vec3>& points) {
  std::vector<Vec3> normals(points.size(), crack.plane.normal);
  if (!crack.front_history.fronts.empty()) {
    std::ranges::transform(points, normals.begin(), [&](const Vec3& x) {
      const geometry::PolylinePosition on =
          geometry::nearest_point(x, crack.front_history.fronts.back());
      return Vec3(on.interpolate(crack.front_history.normals).normalized());
    });
  }
  return normals;
}

model::FrontHistory extend_front_history(const model::CrackDefinition& before,
                                         const mesh::FrontCurve& front,
                                         const mesh::FrontCurve& made) {
  model::FrontHistory front_history = before.front_history;
  if (front_history.fronts.empty()) {
    front_history.fronts.push_back(line_of(front));
  }
  const std::vector<Vec3> old = front_history.fronts.back();
  const std::vector<Vec3> line = line_of(made);
  const std::vector<Vec3> old_normals = crack_normals(before, line);
  std::vector<Vec3> kinematics;
  double most = 0.0;
  for (const Vec3& x : line) {
    kinematics.emplace_back(x - geometry::nearest_point(x, old).interpolate(old));
    most = std::max(most, kinematics.back().norm());
  }
  std::vector<Vec3> normals;
  for (std::size_t i = 0; i < line.size(); ++i) {
    // b = t x m with the way as m, at right angles to the front.
    const Vec3 b = geometry::polyline_direction_at(line, i).cross(kinematics[i]);
    normals.push_back(b.norm() > hardly * most ? Vec3(b.normalized()) : old_normals[i]);
  }
  if (!made.closed()) { // ends beyond the surface are as those at it
    for (const std::size_t i : {1U, 0U}) {
      normals[i] = normals[i + 1];
      normals[normals.size() - 1 - i] = normals[normals.size() - 2 - i];
    }
  }
  front_history.fronts.push_back(line);
  front_history.normals = std::move(normals);
  return front_history;
}

} // namespace spricka::growth
