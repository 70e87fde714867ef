// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/polyline.hpp"

namespace spricka::geometry {

PolylinePosition position_at_length(const std::vector<double>& arc, double s) {
  const auto above = std::upper_bound(arc.begin() + 1, arc.end() - 1, s);
  const auto i = static_cast<std::size_t>(above - arc.begin()) - 1;
  return {i, std::clamp((s - arc[i]) / (arc[i + 1] - arc[i]), 0.0, 1.0)};
}

} // namespace spricka::geometry
