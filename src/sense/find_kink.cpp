// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/find_kink.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace spricka::sense {

namespace {

using base::Vec3;

struct Turns {
  double sum = 0.0;
  double sharpest = 0.0;
  std::size_t at = 0; ///< the point that turns by that
};

Turns turns_of(const std::vector<Vec3>& x, bool closed) {
  Turns turns;
  const std::size_t n = x.size();
  for (std::size_t i = closed ? 0 : 1; i + (closed ? 0 : 1) < n; ++i) {
    const Vec3 before = x[i] - x[(i + n - 1) % n];
    const Vec3 after = x[(i + 1) % n] - x[i];
    const double turn = std::atan2(before.cross(after).norm(), before.dot(after));
    turns.sum += turn;
    if (turn > turns.sharpest) {
      turns.sharpest = turn;
      turns.at = i;
    }
  }
  return turns;
}

} // namespace

std::optional<MisplacedFrontPoint> find_misplaced_front_point(const std::vector<Vec3>& points,
                                                              bool closed) {
  // A half circle drawn by four points turns by half a radian less without one of them, finer lines
  // by less than that. Ends may lie anywhere beyond the body.
  constexpr double most_gained = 1.0;
  constexpr double turned_back = 0.6 * std::numbers::pi; // corners of squares turn by 0.5
  if (points.size() < (closed ? 5U : 4U)) {
    return std::nullopt;
  }
  const Turns whole = turns_of(points, closed);
  MisplacedFrontPoint kink{whole.at, whole.sum, whole.sum};
  for (std::size_t i = closed ? 0 : 1; i + (closed ? 0 : 1) < points.size(); ++i) {
    std::vector<Vec3> others = points;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    if (const double without = turns_of(others, closed).sum; without < kink.without) {
      kink = {i, whole.sum, without};
    }
  }
  if (whole.sum - kink.without > most_gained) {
    return kink;
  }
  if (whole.sharpest > turned_back) {
    std::vector<Vec3> others = points;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(whole.at));
    return MisplacedFrontPoint{whole.at, whole.sum, turns_of(others, closed).sum};
  }
  return std::nullopt;
}

} // namespace spricka::sense
