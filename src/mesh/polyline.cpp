// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/polyline.hpp"

#include <algorithm>

namespace spricka::mesh {

using base::Vec3;

PolylinePosition nearest_on(const std::vector<Vec3>& line, const Vec3& x) {
  PolylinePosition best;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec3 d = line[i + 1] - line[i];
    const double square = d.squaredNorm();
    const double part = square > 0.0 ? std::clamp(d.dot(x - line[i]) / square, 0.0, 1.0) : 0.0;
    const double away = (line[i] + part * d - x).norm();
    if (away < best.distance) {
      best = {i, part, away};
    }
  }
  return best;
}

Vec3 direction_at(const std::vector<Vec3>& line, std::size_t point) {
  const bool closed = line.front() == line.back();
  const std::size_t n = line.size();
  const Vec3& here = line[point];
  const Vec3& next = point + 1 < n ? line[point + 1] : closed ? line[1] : here;
  const Vec3& before = point > 0 ? line[point - 1] : closed ? line[n - 2] : here;
  return (next - before).normalized();
}

} // namespace spricka::mesh
