// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/front_hats.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::crack {

namespace {

double snapped(double part) {
  constexpr double round_off = 1e-9;
  if (part < round_off) {
    return 0.0;
  }
  return part > 1.0 - round_off ? 1.0 : part;
}

} // namespace

FrontHats::FrontHats(const mesh::CrackFront& front, bool closed)
    : curve_(*front.curve), closed_(closed),
      origin_(curve_.nearest_length(front.points.front().x)) {
  for (const mesh::FrontPoint& point : front.points) {
    stations_.push_back(along_front(curve_.nearest_length(point.x)));
  }
  stations_.front() = 0.0;
}

// From the first point on; of a curve that is closed always ahead of it.
double FrontHats::along_front(double s) const {
  const double way = s - origin_;
  const double whole = curve_.length();
  return curve_.closed() ? way - whole * std::floor(way / whole) : way;
}

FrontHatWeights FrontHats::hat_weights_at(double s) const {
  const std::vector<double>& at = stations_;
  const std::size_t last = at.size() - 1;
  if (at.size() == 1) {
    return {0, 0, 0.0};
  }
  const double whole = curve_.length();
  double way = along_front(s);
  if (curve_.closed() && !closed_ && way > 0.5 * (at[last] + whole)) {
    way = 0.0; // before the first point
  }
  if (closed_ && way >= at[last]) {
    return {last, 0, snapped((way - at[last]) / (whole - at[last]))};
  }
  const auto above = std::upper_bound(at.begin(), at.end(), way) - at.begin();
  const std::size_t low = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(above - 1, 0, static_cast<std::ptrdiff_t>(last) - 1));
  return {low, low + 1, snapped((way - at[low]) / (at[low + 1] - at[low]))};
}

} // namespace spricka::crack
