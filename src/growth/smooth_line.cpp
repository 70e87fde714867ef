// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/smooth_line.hpp"

#include "base/dense_solve.hpp"
#include "shape/quadrature.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace spricka::growth {

using base::Vec3;

namespace {

/// Angles [rad] that the curve may turn by over one piece of the polyline and over the piece at a
/// tip: K follows the direction at the tip to first order, kinks farther away to second order.
constexpr double turn_of_chord = 0.05;
constexpr double turn_at_tip = 0.02;
/// The straight piece at a tip as a part of the crack's length, at most.
constexpr double tip_part = 0.25;

/// Second derivatives of the spline at its knots.
std::vector<Vec3> moments(const std::vector<Vec3>& x, const std::vector<double>& knot) {
  const auto n = static_cast<Eigen::Index>(x.size());
  std::vector<Vec3> result(x.size(), Vec3::Zero());
  if (n < 3) {
    return result;
  }
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  Eigen::MatrixXd rhs = Eigen::MatrixXd::Zero(n, 3);
  const auto h = [&](Eigen::Index i) {
    return knot[static_cast<std::size_t>(i) + 1] - knot[static_cast<std::size_t>(i)];
  };
  const auto slope = [&](Eigen::Index i) -> Vec3 {
    return (x[static_cast<std::size_t>(i) + 1] - x[static_cast<std::size_t>(i)]) / h(i);
  };
  for (Eigen::Index i = 1; i + 1 < n; ++i) {
    // The first derivative does not jump at an inner knot.
    A(i, i - 1) = h(i - 1);
    A(i, i) = 2.0 * (h(i - 1) + h(i));
    A(i, i + 1) = h(i);
    rhs.row(i) = 6.0 * (slope(i) - slope(i - 1)).transpose();
  }
  if (n == 3) { // a parabola: one second derivative
    A(0, 0) = A(2, 2) = 1.0;
    A(0, 1) = A(2, 1) = -1.0;
  } else { // the third derivative does not jump at the second and the last but one knot
    A(0, 0) = h(1);
    A(0, 1) = -h(0) - h(1);
    A(0, 2) = h(0);
    A(n - 1, n - 3) = h(n - 2);
    A(n - 1, n - 2) = -h(n - 3) - h(n - 2);
    A(n - 1, n - 1) = h(n - 3);
  }
  const base::Matrix m = base::solve_square(A, rhs);
  for (Eigen::Index i = 0; i < n; ++i) {
    result[static_cast<std::size_t>(i)] = m.row(i).transpose();
  }
  return result;
}

} // namespace

SmoothCurve::SmoothCurve(std::vector<Vec3> points)
    : points_(std::move(points)), knot_{0.0}, arc_{0.0} {
  assert(points_.size() >= 2);
  for (std::size_t i = 1; i < points_.size(); ++i) {
    knot_.push_back(knot_.back() + (points_[i] - points_[i - 1]).norm());
  }
  moment_ = moments(points_, knot_);
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    arc_.push_back(arc_.back() + speed_integral(i, knot_[i + 1] - knot_[i]));
  }
}

Vec3 SmoothCurve::derivative(const CurvePosition& p) const {
  const std::size_t i = p.interval;
  const double h = knot_[i + 1] - knot_[i];
  const Vec3 chord = (points_[i + 1] - points_[i]) / h;
  return chord + moment_[i] * (p.t - 0.5 * p.t * p.t / h - h / 3.0) +
         moment_[i + 1] * (0.5 * p.t * p.t / h - h / 6.0);
}

double SmoothCurve::speed_integral(std::size_t interval, double t) const {
  constexpr int parts = 4; // the speed hardly varies
  double sum = 0.0;
  for (int k = 0; k < parts; ++k) {
    const double half = 0.5 * t / parts;
    for (const auto& [xi, weight] : shape::line_rule(9)) {
      sum += weight * half * derivative({interval, half * (2 * k + 1 + xi[0])}).norm();
    }
  }
  return sum;
}

SmoothCurve::CurvePosition SmoothCurve::find(double s) const {
  // The ends belong to the first and the last interval.
  const auto above = std::upper_bound(arc_.begin() + 1, arc_.end() - 1, s);
  const auto i = static_cast<std::size_t>(above - arc_.begin()) - 1;
  double t = (s - arc_[i]) / (arc_[i + 1] - arc_[i]) * (knot_[i + 1] - knot_[i]);
  for (int k = 0; k < 20; ++k) { // Newton: the speed is the derivative
    const double step = (s - arc_[i] - speed_integral(i, t)) / derivative({i, t}).norm();
    t += step;
    if (std::abs(step) <= 1e-14 * knot_.back()) {
      break;
    }
  }
  return {i, t};
}

Vec3 SmoothCurve::at(double s) const {
  // Straight on along the tangent of the end.
  if (s < 0.0 || s > length()) {
    const double end = s < 0.0 ? 0.0 : length();
    return (s < 0.0 ? points_.front() : points_.back()) + (s - end) * tangent(end);
  }
  const CurvePosition p = find(s);
  const std::size_t i = p.interval;
  const double h = knot_[i + 1] - knot_[i];
  const double a = (h - p.t) / h;
  const double b = p.t / h;
  return a * points_[i] + b * points_[i + 1] +
         h * h / 6.0 * ((a * a * a - a) * moment_[i] + (b * b * b - b) * moment_[i + 1]);
}

Vec3 SmoothCurve::tangent(double s) const {
  return derivative(find(std::clamp(s, 0.0, length()))).normalized();
}

double SmoothCurve::curvature(double s) const {
  if (s < 0.0 || s > length()) {
    return 0.0;
  }
  const CurvePosition p = find(s);
  const double h = knot_[p.interval + 1] - knot_[p.interval];
  const Vec3 second = (1.0 - p.t / h) * moment_[p.interval] + p.t / h * moment_[p.interval + 1];
  const Vec3 first = derivative(p);
  return first.cross(second).norm() / std::pow(first.norm(), 3);
}

std::vector<Vec3> as_polyline(const SmoothCurve& curve, double s0, double s1, bool two_tips) {
  // A piece over which the curve turns by turn_at_tip, no longer than `most`; the inner maximum
  // keeps a straight end from a division by zero.
  const double most = tip_part * (s1 - s0);
  const auto tip_piece = [&](double s) {
    return std::min(most, turn_at_tip / std::max(curve.curvature(s), turn_at_tip / most));
  };
  const double first = two_tips ? s0 + tip_piece(s0) : s0;
  const double last = s1 - tip_piece(s1);
  std::vector<Vec3> points{curve.at(s0)};
  if (two_tips) {
    points.emplace_back(curve.at(s0) + (first - s0) * curve.tangent(s0));
  }
  // as many pieces as it takes for the sharpest bend, equally long
  constexpr int looks = 200;
  double sharpest = 0.0;
  for (int k = 0; k <= looks; ++k) {
    sharpest = std::max(sharpest, curve.curvature(first + (last - first) * k / looks));
  }
  const int pieces =
      std::max(1, static_cast<int>(std::ceil(sharpest * (last - first) / turn_of_chord)));
  for (int k = 1; k < pieces; ++k) {
    points.push_back(curve.at(first + (last - first) * k / pieces));
  }
  points.emplace_back(curve.at(s1) - (s1 - last) * curve.tangent(s1));
  points.push_back(curve.at(s1));
  return points;
}

} // namespace spricka::growth
