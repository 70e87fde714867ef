// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/growing_front.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::growth {

std::size_t GrowingFront::nearest_tip(double number) const {
  return tips[static_cast<std::size_t>(std::lround(number)) % tips.size()];
}

double GrowingFront::advance_between(double number, const std::vector<double>& by) const {
  const auto first = static_cast<std::size_t>(number);
  const double part = number - static_cast<double>(first);
  return (1.0 - part) * by[tips[first % tips.size()]] + part * by[tips[(first + 1) % tips.size()]];
}

FrontKind GrowingFront::kind() const {
  /// Cosine of what a front turns by from end to end at least if it is no straight one: 45 degrees.
  constexpr double hardly_turned = 0.7;
  const double turned = arc.curve.at(0.0).m.dot(arc.curve.at(arc.curve.length()).m);
  return arc.is_closed()          ? FrontKind::closed
         : turned > hardly_turned ? FrontKind::straight
                                  : FrontKind::round;
}

TipOnFront MovingFronts::find_tip_on_front(std::size_t tip) const {
  for (std::size_t g = 0; g < growing.size(); ++g) {
    const GrowingFront& of = growing[g];
    const auto at = std::ranges::find(of.tips, tip);
    if (at != of.tips.end()) {
      return {of, g, static_cast<std::size_t>(at - of.tips.begin())};
    }
  }
  return {growing.front(), 0, 0}; // every tip has a front
}

} // namespace spricka::growth
