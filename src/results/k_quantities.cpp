// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/k_quantities.hpp"

#include "geometry/polyline.hpp"
#include "results/output_word.hpp"

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
  return front.is_loop ? n : n - std::min<std::size_t>(n, 1);
}

// Which of K1, K2, K3, that have a smooth curve, or of these as the mesh has them.
struct CurveOf {
  std::size_t mode = 0;
  bool raw = false;
  [[nodiscard]] double operator()(const FrontPointResult& place) const {
    return (raw ? place.raw_smooth_K() : place.smooth)[mode];
  }
};

std::optional<CurveOf> curve_of(const KQuantity& quantity) {
  static constexpr std::array<std::string_view, 3> raw{"K1_raw", "K2_raw", "K3_raw"};
  if (quantity.is_k()) {
    return CurveOf{static_cast<std::size_t>(quantity.mode), false};
  }
  const auto* const found = std::ranges::find(raw, quantity.name);
  return found == raw.end()
             ? std::nullopt
             : std::optional<CurveOf>({static_cast<std::size_t>(found - raw.begin()), true});
}

// The cubic through the smooth values of the two points on either side of a place (fewer on a front
// of fewer): K at a point is the mean over its hat, and chords between points cut the curve by as
// much again.
double on_curve(const FrontResult& front, const CurveOf& curve, std::size_t piece, double part) {
  const std::size_t n = front.points.size();
  const std::size_t count = std::min<std::size_t>(n, 4);
  // The first of them, counted from 1 so that a closed front may begin before its first point.
  const std::size_t first =
      front.is_loop ? piece : std::clamp<std::size_t>(piece, 1, n - count + 1);
  std::array<double, 4> s{};
  std::array<double, 4> value{};
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = first + k + n - 1;
    const std::size_t rounds = i / n; // one more than there are
    s[k] = front.points[i % n].s + front.length * (static_cast<double>(rounds) - 1.0);
    value[k] = curve(front.points[i % n]);
  }
  const double from = front.points[piece].s;
  const double to = piece + 1 < n ? front.points[piece + 1].s : front.points[0].s + front.length;
  const double at = (1.0 - part) * from + part * to;
  double sum = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    double weight = 1.0;
    for (std::size_t j = 0; j < count; ++j) {
      weight *= j == k ? 1.0 : (at - s[j]) / (s[k] - s[j]);
    }
    sum += weight * value[k];
  }
  return sum;
}

double between(const FrontResult& front, const KQuantity& quantity, std::size_t piece,
               double part) {
  if (const auto curve = curve_of(quantity)) {
    return on_curve(front, *curve, piece, part);
  }
  const FrontPointResult& from = front.points[piece];
  const FrontPointResult& to = front.points[(piece + 1) % front.points.size()];
  return (1.0 - part) * quantity.extract_value(front, from) +
         part * quantity.extract_value(front, to);
}

} // namespace

bool KQuantity::is_given(const FrontResult& front) const {
  switch (given) {
  case KQuantityCondition::in_one_material:
    return !front.two_materials;
  case KQuantityCondition::with_bar:
    return front.has_error_bar();
  case KQuantityCondition::with_opening:
    return std::ranges::all_of(
        front.points, [](const FrontPointResult& point) { return point.opening.has_value(); });
  case KQuantityCondition::with_angles:
    return front.has_angles;
  case KQuantityCondition::always:
    break;
  }
  return true;
}

std::string KQuantity::check_word() const {
  std::string word = uppercase_column_name(name);
  std::ranges::replace(word, '_', '.');
  return word;
}

const KQuantity* find_k_quantity(std::string_view check_word, int dim) {
  const std::string_view word = check_word == "K" ? "K1" : check_word;
  const auto* const found = std::ranges::find_if(k_quantities, [&](const KQuantity& q) {
    return q.appears_in(in_check, dim) && q.check_word() == word;
  });
  return found == k_quantities.end() ? nullptr : found;
}

double front_value_near(const FrontResult& front, const KQuantity& quantity, const base::Vec3& x) {
  double least = std::numeric_limits<double>::max();
  double value = quantity.extract_value(front, front.points.front());
  for (std::size_t i = 0; i < piece_count(front); ++i) {
    const auto [part, away] = geometry::nearest_point(
        x, front.points[i].x, front.points[(i + 1) % front.points.size()].x);
    if (away < least) {
      least = away;
      value = between(front, quantity, i, part);
    }
  }
  return value;
}

std::optional<double> front_value_at_angle(const FrontResult& front, const KQuantity& quantity,
                                           double phi) {
  for (std::size_t i = 0; front.has_angles && i < piece_count(front); ++i) {
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

std::optional<double> front_value_at_length(const FrontResult& front, const KQuantity& quantity,
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
