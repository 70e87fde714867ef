// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/section_plane.hpp"

#include <cmath>

namespace spricka::sense {

using base::Vec3;

int SectionPlane::space_direction_index(int d) const {
  return round && d == 1 ? axis : (axis + 1 + d) % 3;
}

Vec3 SectionPlane::section_coordinates(const Vec3& x) const {
  const double u = x[(axis + 1) % 3];
  const double v = x[(axis + 2) % 3];
  return round ? Vec3(std::hypot(u, v), x[axis], 0.0) : Vec3(u, v, 0.0);
}

Vec3 SectionPlane::space_point(const Vec3& place, double along) const {
  Vec3 x = Vec3::Zero();
  x[axis] = round ? place.y() : along;
  x[(axis + 1) % 3] = place.x() * (round ? std::cos(along) : 1.0);
  x[(axis + 2) % 3] = round ? place.x() * std::sin(along) : place.y();
  return x;
}

double SectionPlane::normal_coordinate(const Vec3& x) const {
  return round ? std::atan2(x[(axis + 2) % 3], x[(axis + 1) % 3]) : x[axis];
}

Vec3 SectionPlane::normal(const Vec3& x) const {
  Vec3 n = Vec3::Zero();
  if (!round) {
    n[axis] = 1.0;
    return n;
  }
  const double radius = section_coordinates(x).x();
  if (radius > reach) {
    n[(axis + 1) % 3] = -x[(axis + 2) % 3] / radius;
    n[(axis + 2) % 3] = x[(axis + 1) % 3] / radius;
  }
  return n;
}

} // namespace spricka::sense
