// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/front_result.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace spricka::results {

namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr double beside = 1e-6; // of the range: round-off beyond the last point

// Pieces between neighbouring points; the last one of a closed front joins its ends.
std::size_t piece_count(const FrontResult& front) {
  const std::size_t n = front.points.size();
  return front.closed ? n : n - std::min<std::size_t>(n, 1);
}

// K where the front leaves the body is a number of the mesh: what the points further in go on to
// stands for it between points.
double inner_value(const FrontPlace& place, const FrontQuantity& quantity) {
  static constexpr std::array modes{&FrontPlace::K1, &FrontPlace::K2, &FrontPlace::K3};
  const auto* const mode = std::ranges::find(modes, quantity.member);
  return place.at_surface && mode != modes.end()
             ? place.smooth[static_cast<std::size_t>(mode - modes.begin())]
             : quantity.of(place);
}

double between(const FrontResult& front, const FrontQuantity& quantity, std::size_t piece,
               double part) {
  const FrontPlace& from = front.points[piece];
  const FrontPlace& to = front.points[(piece + 1) % front.points.size()];
  return (1.0 - part) * inner_value(from, quantity) + part * inner_value(to, quantity);
}

} // namespace

const FrontQuantity* find_front_quantity(std::string_view name) {
  const std::string_view word = name == "K" ? "K1" : name;
  const auto* const found = std::ranges::find_if(
      front_quantities, [&](const FrontQuantity& q) { return word == q.name; });
  return found == front_quantities.end() ? nullptr : found;
}

double front_value_near(const FrontResult& front, const FrontQuantity& quantity,
                        const base::Vec3& x) {
  double least = std::numeric_limits<double>::max();
  double value = quantity.of(front.points.front());
  for (std::size_t i = 0; i < piece_count(front); ++i) {
    const base::Vec3& from = front.points[i].x;
    const base::Vec3 along = front.points[(i + 1) % front.points.size()].x - from;
    const double part = std::clamp((x - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    const double away = (from + part * along - x).norm();
    if (away < least) {
      least = away;
      value = between(front, quantity, i, part);
    }
  }
  return value;
}

std::optional<double> front_value_at_angle(const FrontResult& front, const FrontQuantity& quantity,
                                           double phi) {
  for (std::size_t i = 0; front.angles && i < piece_count(front); ++i) {
    const double from = front.points[i].phi;
    // Pieces are short: the smaller of the two ways round.
    const double step =
        std::remainder(front.points[(i + 1) % front.points.size()].phi - from, two_pi);
    const double there = std::remainder(phi - from, two_pi);
    const double part = there / step;
    if (part >= -beside && part <= 1.0 + beside) {
      return between(front, quantity, i, std::clamp(part, 0.0, 1.0));
    }
  }
  return std::nullopt;
}

std::optional<double> front_value_at_length(const FrontResult& front, const FrontQuantity& quantity,
                                            double s) {
  for (std::size_t i = 0; i < piece_count(front); ++i) {
    const double from = front.points[i].s;
    const double to = i + 1 < front.points.size() ? front.points[i + 1].s : front.length;
    const double part = (s - from) / (to - from);
    if (part >= -beside && part <= 1.0 + beside) {
      return between(front, quantity, i, std::clamp(part, 0.0, 1.0));
    }
  }
  return std::nullopt;
}

} // namespace spricka::results
