// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/load_path.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::results {

FrontResult LoadPathFront::at(double t) const {
  FrontResult front = front_without_points;
  for (const LoadPathFrontPoint& point : points) {
    FrontPointResult& place = front.points.emplace_back(point.point_at_start);
    place.closed = false;  // a path knows K of its points, not what faces do there
    put_back_raw_K(place); // of the path's end alone
    place.K1 = point.K[0](t);
    place.K2 = point.K[1](t);
    place.K3 = point.K[2](t);
    for (std::size_t k = 0; k < 3; ++k) {
      place.smooth[k] = point.smooth[k](t);
    }
  }
  return front;
}

const LoadPathFront* find_front(const LoadPathResult& path, std::string_view front) {
  const auto it = std::ranges::find_if(
      path.fronts, [&](const LoadPathFront& f) { return f.front_without_points.name == front; });
  return it == path.fronts.end() ? nullptr : &*it;
}

const LoadPathContact* find_contact(const LoadPathResult& path, std::string_view contact) {
  const auto it = std::ranges::find(path.contacts, contact, &LoadPathContact::name);
  return it == path.contacts.end() ? nullptr : &*it;
}

std::optional<double> k_at_load_combination(const LoadPathResult& path,
                                            const LoadPathFrontPoint& point, int mode, double a,
                                            double b) {
  const double sum = a + b;
  if (!(sum > 0.0) || (!path.homogeneous && std::abs(sum - 1.0) > 1e-12)) {
    return std::nullopt;
  }
  const double K = point.K[static_cast<std::size_t>(mode - 1)](b / sum);
  return std::isnan(K) ? std::nullopt : std::optional(sum * K);
}

} // namespace spricka::results
