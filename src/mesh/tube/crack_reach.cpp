// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/crack_reach.hpp"

#include "geometry/box.hpp"
#include "geometry/polyline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spricka::mesh {

using base::Vec2;
using base::Vec3;

void CrackDistanceField::add_tube(const Tube& tube) {
  const std::size_t n = tube.stations.size();
  free_ = free_ || tube.free;
  for (std::size_t i = 0; i < (tube.closed ? n : n - 1); ++i) {
    const std::size_t next = (i + 1) % n;
    pieces_.push_back({tube.stations[i].x, tube.stations[next].x,
                       std::max(tube.radius[i], tube.radius[next]),
                       std::max(tube.fill_size_beside_tube(i), tube.fill_size_beside_tube(next))});
  }
  geometry::Box<3> box;
  double most = 0.0;
  for (const std::vector<Vec2>& outline : area_.outlines()) {
    for (const Vec2& q : outline) {
      const Vec3 x = plane().lift_to_crack(q);
      box.extend({x, x});
    }
  }
  for (const FrontSegment& piece : pieces_) {
    box.extend({piece.from, piece.from});
    most = std::max(most, piece.radius);
  }
  middle_ = 0.5 * (box.low + box.high);
  radius_ = 0.5 * box.diagonal() + most;
}

CrackDistanceField::CrackDistances CrackDistanceField::distance(const Vec3& p) const {
  CrackDistances result;
  double least = std::numeric_limits<double>::max();
  for (const FrontSegment& piece : pieces_) {
    const Vec3 along = piece.to - piece.from;
    const double part = geometry::nearest_segment_parameter(p, piece.from, piece.to);
    const double d = (piece.from + part * along - p).squaredNorm();
    if (d < least) {
      least = d;
      result.radius = piece.radius;
      result.size = piece.size;
    }
  }
  result.front = std::sqrt(least);
  result.surface = area_.distance(p);
  return result;
}

} // namespace spricka::mesh
