// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/cubic_spline.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <type_traits>
#include <utility>

namespace spricka::geometry {

namespace {

template <class Value> Value zero_value() {
  if constexpr (std::is_arithmetic_v<Value>) {
    return 0.0;
  } else {
    return Value::Zero();
  }
}

/// Equations below[i] x[i - 1] + diagonal[i] x[i] + above[i] x[i + 1] = right[i], subscripts
/// counted round; with below.front() = above.back() = 0 a matrix of three diagonals.
template <class Value> struct CyclicEquations {
  std::vector<double> below, diagonal, above;
  std::vector<Value> right;
};

// The matrix is dominated by its diagonal, so no pivots are sought. Of the last unknown, the only
// one that makes the equations cyclic, the others are linear functions: right - by_last x.back().
template <class Value> std::vector<Value> solve_equations(CyclicEquations<Value> equations) {
  auto& [below, diagonal, above, right] = equations;
  const std::size_t last = right.size() - 1;
  assert(last > 0);
  std::vector<double> by_last(last, 0.0);
  by_last.front() += below.front();
  by_last.back() += above[last - 1];
  for (std::size_t i = 1; i < last; ++i) {
    const double factor = below[i] / diagonal[i - 1];
    diagonal[i] -= factor * above[i - 1];
    by_last[i] -= factor * by_last[i - 1];
    right[i] -= factor * right[i - 1];
  }
  for (std::size_t i = last; i-- > 0;) {
    if (i + 1 < last) {
      by_last[i] -= above[i] * by_last[i + 1];
      right[i] -= above[i] * right[i + 1];
    }
    by_last[i] /= diagonal[i];
    right[i] /= diagonal[i];
  }
  right[last] -= below[last] * right[last - 1] + above[last] * right[0];
  right[last] /= diagonal[last] - below[last] * by_last[last - 1] - above[last] * by_last[0];
  for (std::size_t i = 0; i < last; ++i) {
    right[i] -= by_last[i] * right[last];
  }
  return std::move(right);
}

// Second derivatives M at the knots: h0 M0 + 2 (h0 + h1) M1 + h1 M2 = 6 (slope after - slope
// before) where the first derivative does not jump.
template <class Value> class SplineFit {
public:
  SplineFit(const std::vector<double>& knots, const std::vector<Value>& values)
      : x_(knots), y_(values) {}

  [[nodiscard]] std::vector<Value> not_a_knot() {
    const std::size_t n = x_.size();
    if (n == 2) {
      return std::vector<Value>(n, zero_value<Value>());
    }
    if (n == 3) {
      return std::vector<Value>(n, Value(2.0 * (slope(1) - slope(0)) / (x_[2] - x_[0])));
    }
    for (std::size_t i = 1; i + 1 < n; ++i) {
      add_knot(i - 1, i);
    }
    // M at an end is that of its neighbour and as much more as it rises from the one after on: M0 =
    // M1 + h0 / h1 (M1 - M2), eliminated.
    const double first = h(0) / h(1);
    const double last = h(n - 2) / h(n - 3);
    equations_.below.front() = equations_.above.back() = 0.0;
    equations_.diagonal.front() += h(0) * (1.0 + first);
    equations_.above.front() -= h(0) * first;
    equations_.diagonal.back() += h(n - 2) * (1.0 + last);
    equations_.below.back() -= h(n - 2) * last;
    std::vector<Value> bend = solve_equations(std::move(equations_));
    bend.insert(bend.begin(), Value(bend[0] + first * (bend[0] - bend[1])));
    bend.push_back(Value(bend[n - 2] + last * (bend[n - 2] - bend[n - 3])));
    return bend;
  }

  [[nodiscard]] std::vector<Value> periodic() {
    const std::size_t count = x_.size() - 1;
    for (std::size_t i = 0; i < count; ++i) {
      add_knot(i > 0 ? i - 1 : count - 1, i);
    }
    std::vector<Value> bend = solve_equations(std::move(equations_));
    bend.push_back(Value(bend.front()));
    return bend;
  }

private:
  [[nodiscard]] double h(std::size_t i) const { return x_[i + 1] - x_[i]; }
  [[nodiscard]] Value slope(std::size_t i) const { return (y_[i + 1] - y_[i]) / h(i); }

  /// The equation of the knot between two intervals.
  void add_knot(std::size_t before, std::size_t after) {
    equations_.below.push_back(h(before));
    equations_.diagonal.push_back(2.0 * (h(before) + h(after)));
    equations_.above.push_back(h(after));
    equations_.right.push_back(6.0 * (slope(after) - slope(before)));
  }

  const std::vector<double>& x_;
  const std::vector<Value>& y_;
  CyclicEquations<Value> equations_;
};

} // namespace

template <class Value>
CubicSpline<Value>::CubicSpline(std::vector<double> knots, std::vector<Value> values,
                                SplineEndCondition ends)
    : knots_(std::move(knots)), values_(std::move(values)), ends_(ends) {
  assert(knots_.size() == values_.size() && knots_.size() >= 2);
  SplineFit<Value> fit(knots_, values_);
  if (ends_ == SplineEndCondition::not_a_knot) {
    bend_ = fit.not_a_knot();
  } else {
    assert(knots_.size() >= 4 && values_.front() == values_.back());
    bend_ = fit.periodic();
  }
}

template <class Value> SplinePosition CubicSpline<Value>::locate(double x) const {
  if (ends_ == SplineEndCondition::periodic) {
    const double period = knots_.back() - knots_.front();
    x -= period * std::floor((x - knots_.front()) / period);
  }
  const auto above = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, x);
  const auto i = static_cast<std::size_t>(above - knots_.begin()) - 1;
  return {i, x - knots_[i]};
}

template <class Value> Value CubicSpline<Value>::value(const SplinePosition& at) const {
  const std::size_t i = at.interval;
  const double h = interval_width(i);
  const double t = at.offset / h;
  const double s = 1.0 - t;
  return s * values_[i] + t * values_[i + 1] -
         h * h / 6.0 * s * t * ((1.0 + s) * bend_[i] + (1.0 + t) * bend_[i + 1]);
}

template <class Value> Value CubicSpline<Value>::first_derivative(const SplinePosition& at) const {
  const std::size_t i = at.interval;
  const double h = interval_width(i);
  const double t = at.offset / h;
  const double s = 1.0 - t;
  return (values_[i + 1] - values_[i]) / h +
         h / 6.0 * ((1.0 - 3.0 * s * s) * bend_[i] + (3.0 * t * t - 1.0) * bend_[i + 1]);
}

template <class Value> Value CubicSpline<Value>::second_derivative(const SplinePosition& at) const {
  const std::size_t i = at.interval;
  const double t = at.offset / interval_width(i);
  return (1.0 - t) * bend_[i] + t * bend_[i + 1];
}

template class CubicSpline<double>;
template class CubicSpline<base::Vec2>;
template class CubicSpline<base::Vec3>;

} // namespace spricka::geometry
