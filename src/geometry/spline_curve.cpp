// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/spline_curve.hpp"

#include "geometry/polyline.hpp"
#include "shape/quadrature.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

namespace spricka::geometry {

using base::Vec3;

namespace {

CubicSpline<Vec3> spline_over_chords(std::vector<Vec3> points, bool closed) {
  assert(points.size() >= (closed ? 4U : 2U));
  if (closed) {
    points.push_back(Vec3(points.front()));
  }
  std::vector<double> knots = arc_lengths(points);
  return {std::move(knots), std::move(points),
          closed ? SplineEndCondition::periodic : SplineEndCondition::not_a_knot};
}

} // namespace

SplineCurve::SplineCurve(std::vector<Vec3> points, bool closed, int parts)
    : closed_(closed), parts_(parts),
      spline_(spline_over_chords(std::move(points), closed)), arc_{0.0} {
  for (std::size_t i = 0; i < spline_.interval_count(); ++i) {
    assert(spline_.interval_width(i) > 0.0);
    arc_.push_back(arc_.back() + length_to({i, spline_.interval_width(i)}));
  }
}

double SplineCurve::length_to(const SplinePosition& at) const {
  constexpr int degree = 9;
  const double half = 0.5 * at.offset / parts_;
  double sum = 0.0;
  for (int k = 0; k < parts_; ++k) {
    for (const auto& [r, weight] : shape::line_rule(degree)) {
      sum += weight * spline_.first_derivative({at.interval, half * (2 * k + 1 + r[0])}).norm();
    }
  }
  return half * sum;
}

SplinePosition SplineCurve::locate(double s) const {
  const PolylinePosition chord = position_at_length(arc_, s);
  const double h = spline_.interval_width(chord.piece);
  SplinePosition at{chord.piece, chord.part * h};
  // Newton's steps: the speed is nearly 1 by the chord parameter.
  for (int i = 0; i < 20; ++i) {
    const double missing = s - arc_[at.interval] - length_to(at);
    const double step = missing / spline_.first_derivative(at).norm();
    at.offset += step;
    if (std::abs(step) < 1e-15 * h) {
      break;
    }
  }
  return at;
}

SplineCurvePoint SplineCurve::point(double s) const {
  const double inside =
      closed_ ? s - length() * std::floor(s / length()) : std::clamp(s, 0.0, length());
  SplineCurvePoint result;
  result.position = locate(inside);
  result.x = spline_.value(result.position);
  result.first = spline_.first_derivative(result.position);
  result.second = spline_.second_derivative(result.position);
  if (!closed_ && inside != s) {
    result.beyond = s - inside;
    result.x += result.beyond * result.first.normalized();
  }
  return result;
}

double SplineCurve::curvature(double s) const {
  const SplineCurvePoint at = point(s);
  return at.beyond != 0.0 ? 0.0 : at.first.cross(at.second).norm() / std::pow(at.first.norm(), 3);
}

SplinePosition SplineCurve::nearest_on(std::size_t interval, const Vec3& x) const {
  const std::vector<Vec3>& points = spline_.values();
  const double h = spline_.interval_width(interval);
  SplinePosition at{interval,
                    h * nearest_segment_parameter(x, points[interval], points[interval + 1])};
  for (int i = 0; i < 12; ++i) {
    const Vec3 off = spline_.value(at) - x;
    const Vec3 first = spline_.first_derivative(at);
    // Beyond the centre of curvature the second derivative changes its sign: Gauss' step then.
    const double square = first.squaredNorm();
    const double full = square + off.dot(spline_.second_derivative(at));
    const double step = -off.dot(first) / (full > 0.1 * square ? full : square);
    const double moved = std::clamp(at.offset + step, 0.0, h);
    const bool still = std::abs(moved - at.offset) < 1e-14 * h;
    at.offset = moved;
    if (still) {
      break;
    }
  }
  return at;
}

double SplineCurve::nearest_length(const Vec3& x) const {
  // Intervals by their chords; those that may be nearest are asked exactly.
  const std::vector<Vec3>& points = spline_.values();
  const std::size_t count = spline_.interval_count();
  std::vector<double> away(count);
  for (std::size_t i = 0; i < count; ++i) {
    away[i] = distance_to_segment(x, points[i], points[i + 1]);
  }
  const double least = *std::ranges::min_element(away);
  double best = std::numeric_limits<double>::max();
  SplinePosition place;
  for (std::size_t i = 0; i < count; ++i) {
    // A curve bulges by a part of its chord.
    if (away[i] > least + 0.3 * spline_.interval_width(i)) {
      continue;
    }
    const SplinePosition at = nearest_on(i, x);
    const double distance = (spline_.value(at) - x).norm();
    if (distance < best) {
      best = distance;
      place = at;
    }
  }
  const double s = arc_[place.interval] + length_to(place);
  if (closed_) {
    return s >= length() ? s - length() : s;
  }
  const bool at_first = place.interval == 0 && place.offset == 0.0;
  const bool at_last =
      place.interval + 1 == count && place.offset == spline_.interval_width(count - 1);
  if (at_first || at_last) {
    const SplineCurvePoint end = point(s);
    return s + (x - end.x).dot(end.first.normalized());
  }
  return s;
}

} // namespace spricka::geometry
