// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <algorithm>
#include <limits>
#include <span>

namespace spricka::geometry {

/// An axis-aligned box of the plane (dim 2) or of space (dim 3), its faces included [length]. Empty
/// as made: it contains nothing and is infinitely far away.
template <int dim> struct Box {
  using Point = Eigen::Matrix<double, dim, 1>;

  Point low = Point::Constant(std::numeric_limits<double>::infinity());
  Point high = Point::Constant(-std::numeric_limits<double>::infinity());

  /// The smallest box with all `points`; empty of none.
  static Box around(std::span<const Point> points) {
    Box box;
    for (const Point& x : points) {
      box.extend({x, x});
    }
    return box;
  }

  /// Makes the box as large as it takes to hold the other one too.
  void extend(const Box& other) {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
  /// Larger by `margin` [length] on all sides.
  [[nodiscard]] Box grown(double margin) const {
    return {low.array() - margin, high.array() + margin};
  }
  /// Length of the diagonal; infinite of an empty box.
  [[nodiscard]] double diagonal() const { return (high - low).norm(); }
  /// Whether a point lies in the box or on its border.
  [[nodiscard]] bool contains(const Point& x) const { return meets({x, x}); }
  /// Whether two boxes have a point in common, their borders included.
  [[nodiscard]] bool meets(const Box& other) const {
    return (low.array() <= other.high.array()).all() && (high.array() >= other.low.array()).all();
  }
  /// Whether the segment between two points meets the box: the stretches of its line between each
  /// pair of faces have a part in common (Kay and Kajiya 1986).
  [[nodiscard]] bool meets_segment(const Point& from, const Point& to) const;
  /// Distance of a point from the box; 0 inside [length].
  [[nodiscard]] double distance(const Point& x) const {
    return (low - x).cwiseMax(x - high).cwiseMax(0.0).norm();
  }
};

template <int dim> bool Box<dim>::meets_segment(const Point& from, const Point& to) const {
  double begin = 0.0; // of the common part, in lengths of the segment
  double end = 1.0;
  for (int i = 0; i < dim; ++i) {
    const double below = low[i] - from[i];
    const double above = high[i] - from[i];
    const double d = to[i] - from[i];
    if (d == 0.0) {
      if (below > 0.0 || above < 0.0) {
        return false;
      }
      continue;
    }
    begin = std::max(begin, std::min(below / d, above / d));
    end = std::min(end, std::max(below / d, above / d));
  }
  return begin <= end;
}

} // namespace spricka::geometry
