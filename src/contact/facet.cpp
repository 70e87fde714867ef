// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/facet.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace spricka::contact {

FacetValues facet_hats(const geometry::ElementSide& facet, const Vec2& r) {
  assert(facet.is_edge());
  return line_hats(static_cast<int>(facet.nodes.size()), r[0]);
}

FacetValues line_hats(int count, double xi) {
  if (count == 2) {
    return {0.5 * (1.0 - xi), 0.5 * (1.0 + xi), 0.0};
  }
  return {std::max(0.0, -xi), std::max(0.0, xi), 1.0 - std::abs(xi)};
}

} // namespace spricka::contact
