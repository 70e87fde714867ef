// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <cstddef>
#include <vector>

namespace spricka::geometry {

/// What a cubic spline fulfils at its first and last knot.
enum class SplineEndCondition {
  not_a_knot, ///< the third derivative does not jump at the second and the last but one knot
  periodic    ///< value and derivatives at the last knot are those at the first
};

/// A place on a spline, in one of the intervals between its knots.
struct SplinePosition {
  std::size_t interval = 0;
  double offset = 0.0; ///< parameter from the interval's first knot
};

/// Interpolating cubic spline, twice continuously differentiable (de Boor 1978, chapter IV), of
/// numbers or of points over one parameter. With ends not-a-knot it is a parabola through three
/// points, a straight line through two, and outside of its knots the first and the last cubic go
/// on; a periodic one is repeated. For `double`, `base::Vec2` and `base::Vec3`.
template <class Value> class CubicSpline {
public:
  /// knots [n], ascending; values [n], n >= 2; periodic: n >= 4, the last value is the first again.
  CubicSpline(std::vector<double> knots, std::vector<Value> values,
              SplineEndCondition ends = SplineEndCondition::not_a_knot);

  /// Where a parameter lies; at an inner knot the interval behind it.
  [[nodiscard]] SplinePosition locate(double x) const;
  /// The value at a place; the end cubics go on beyond the knots.
  [[nodiscard]] Value value(const SplinePosition& at) const;
  /// The derivative by the parameter at a place.
  [[nodiscard]] Value first_derivative(const SplinePosition& at) const; ///< [1/parameter]
  /// The second derivative by the parameter at a place, linear within each interval.
  [[nodiscard]] Value second_derivative(const SplinePosition& at) const;
  /// The value at a parameter, located first.
  [[nodiscard]] Value value(double x) const { return value(locate(x)); }

  [[nodiscard]] std::size_t interval_count() const { return knots_.size() - 1; }
  /// Length of an interval in the parameter.
  [[nodiscard]] double interval_width(std::size_t i) const { return knots_[i + 1] - knots_[i]; }
  [[nodiscard]] const std::vector<double>& knots() const { return knots_; }
  [[nodiscard]] const std::vector<Value>& values() const { return values_; }

private:
  std::vector<double> knots_;
  std::vector<Value> values_; ///< [knot]
  std::vector<Value> bend_;   ///< [knot] second derivative
  SplineEndCondition ends_;
};

extern template class CubicSpline<double>;
extern template class CubicSpline<base::Vec2>;
extern template class CubicSpline<base::Vec3>;

} // namespace spricka::geometry
