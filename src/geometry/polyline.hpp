// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "shape/shape.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

/// Segments, and lines of segments, in the plane and in space. Closed lines end with their first
/// point; outlines are closed without it.
namespace spricka::geometry {

/// The part [0, 1] of the way from a to b at which their segment is nearest to x; 0 where a is b.
template <int dim>
[[nodiscard]] double nearest_segment_parameter(const shape::Point<dim>& x,
                                               const std::type_identity_t<shape::Point<dim>>& a,
                                               const std::type_identity_t<shape::Point<dim>>& b) {
  const shape::Point<dim> along = b - a;
  const double square = along.squaredNorm();
  return square > 0.0 ? std::clamp((x - a).dot(along) / square, 0.0, 1.0) : 0.0;
}

/// The point of a segment that is nearest to another point.
struct NearestSegmentPoint {
  double part = 0.0; ///< of the way from the segment's first end to its second
  double distance = std::numeric_limits<double>::max();
};

/// The point of the segment from a to b that is nearest to x.
template <int dim>
[[nodiscard]] NearestSegmentPoint nearest_point(const shape::Point<dim>& x,
                                                const std::type_identity_t<shape::Point<dim>>& a,
                                                const std::type_identity_t<shape::Point<dim>>& b) {
  const double part = nearest_segment_parameter(x, a, b);
  return {part, (x - a - part * (b - a)).norm()};
}

/// Distance of x from the segment from a to b, both ends included [length].
template <int dim>
[[nodiscard]] double distance_to_segment(const shape::Point<dim>& x,
                                         const std::type_identity_t<shape::Point<dim>>& a,
                                         const std::type_identity_t<shape::Point<dim>>& b) {
  return nearest_point(x, a, b).distance;
}

/// A place on a line.
struct PolylinePosition {
  std::size_t piece = 0; ///< from this point to the next
  double part = 0.0;     ///< of the piece

  /// Between two values that points have.
  template <class Value> [[nodiscard]] Value interpolate(const std::vector<Value>& values) const {
    return values[piece] + part * (values[piece + 1] - values[piece]);
  }
};

/// The place of a line that is nearest to a point.
struct NearestPolylinePoint : PolylinePosition {
  double distance = std::numeric_limits<double>::max();
};

/// The place of a line [>= 2 points] that is nearest to x, the first of several; of fewer points
/// none, endlessly far away.
template <int dim>
[[nodiscard]] NearestPolylinePoint nearest_point(const shape::Point<dim>& x,
                                                 const std::vector<shape::Point<dim>>& line) {
  NearestPolylinePoint best;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const NearestSegmentPoint on = nearest_point(x, line[i], line[i + 1]);
    if (on.distance < best.distance) {
      best = {{i, on.part}, on.distance};
    }
  }
  return best;
}

/// Distance of x from an outline [corner], the last of whose sides goes back to its first corner;
/// from one without corners endless.
template <int dim>
[[nodiscard]] double distance_to_outline(const shape::Point<dim>& x,
                                         const std::vector<shape::Point<dim>>& corners) {
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    least = std::min(least, distance_to_segment(x, corners[i], corners[(i + 1) % corners.size()]));
  }
  return least;
}

/// The direction of a line [>= 2 points] at one of its points, unit: that of the chord between its
/// neighbours, at the ends of an open line that of its first or last piece.
template <int dim>
[[nodiscard]] shape::Point<dim> polyline_direction_at(const std::vector<shape::Point<dim>>& line,
                                                      std::size_t point) {
  const bool closed = line.front() == line.back();
  const std::size_t n = line.size();
  const shape::Point<dim>& here = line[point];
  const shape::Point<dim>& next = point + 1 < n ? line[point + 1] : closed ? line[1] : here;
  const shape::Point<dim>& before = point > 0 ? line[point - 1] : closed ? line[n - 2] : here;
  return (next - before).normalized();
}

/// Length of a line up to each of its points [point], the first 0.
template <int dim>
[[nodiscard]] std::vector<double> arc_lengths(const std::vector<shape::Point<dim>>& line) {
  std::vector<double> arc{0.0};
  for (std::size_t i = 1; i < line.size(); ++i) {
    arc.push_back(arc.back() + (line[i] - line[i - 1]).norm());
  }
  return arc;
}

/// Length of a line; of fewer than two points 0.
template <int dim>
[[nodiscard]] double polyline_length(const std::vector<shape::Point<dim>>& line) {
  return arc_lengths(line).back();
}

/// The place of a line at a length s from its first point, `arc` [>= 2] the lengths up to its
/// points; beyond its ends the end.
[[nodiscard]] PolylinePosition position_at_length(const std::vector<double>& arc, double s);

} // namespace spricka::geometry
