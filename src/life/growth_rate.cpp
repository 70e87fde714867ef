// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/growth_rate.hpp"

#include "life/smoothing.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <Eigen/Dense>

namespace spricka::life {

using model::TestRateMethod;

namespace {

// What four readings say of their scatter: |c . a| / |c| with the weights c of the third divided
// difference, which annul every parabola. Its standard deviation is that of one reading.
double pseudo_residual(std::span<const CrackReading> four) {
  double sum = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    double product = 1.0;
    for (std::size_t j = 0; j < 4; ++j) {
      product *= i == j ? 1.0 : four[i].cycles - four[j].cycles;
    }
    sum += four[i].a / product;
    square += 1.0 / (product * product);
  }
  return std::fabs(sum) / std::sqrt(square);
}

// Standard deviation of the readings by the median of their pseudo-residuals, which the steep end
// of a test does not move (Gasser, Sroka, Jennen-Steinmetz 1986, with third differences).
double scatter_of(std::span<const CrackReading> readings) {
  std::vector<double> residuals;
  for (std::size_t i = 0; i + 4 <= readings.size(); ++i) {
    residuals.push_back(pseudo_residual(readings.subspan(i, 4)));
  }
  if (residuals.empty()) {
    return std::nan("");
  }
  const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
  std::nth_element(residuals.begin(), middle, residuals.end());
  constexpr double median_of_normal = 0.6744897501960817; // of |x|, x standard normal
  return *middle / median_of_normal;
}

MeasuredGrowthRates secants(std::span<const CrackReading> readings) {
  MeasuredGrowthRates found;
  found.scatter = scatter_of(readings);
  // So many degrees of freedom that the quantile is that of the normal distribution (life.15).
  const double both_ends = std::sqrt(2.0) * found.scatter * two_sided_student_quantile_95(1e9);
  for (std::size_t i = 1; i < readings.size(); ++i) {
    const CrackReading& before = readings[i - 1];
    const CrackReading& now = readings[i];
    const double passed = now.cycles - before.cycles;
    found.points.push_back({.cycles = 0.5 * (before.cycles + now.cycles),
                            .a = 0.5 * (before.a + now.a),
                            .rate = (now.a - before.a) / passed,
                            .half_width = both_ends / passed});
  }
  return found;
}

// A parabola through the readings of a window by least squares, taken at its middle.
struct Parabola {
  double value = 0.0;
  double slope = 0.0;       ///< by cycles
  double slope_error = 0.0; ///< standard deviation of slope if the residuals' is 1
  double square = 0.0;      ///< of the weighted residuals, their sum
};

Parabola fit(std::span<const CrackReading> window, bool logarithmic) {
  const auto n = static_cast<Eigen::Index>(window.size());
  const double middle = window[window.size() / 2].cycles;
  // Cycles from -1 to 1 about the middle: columns of one size, however many cycles a test takes.
  const double scale = 0.5 * (window.back().cycles - window.front().cycles);
  Eigen::MatrixXd X(n, 3);
  Eigen::VectorXd y(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const CrackReading& reading = window[static_cast<std::size_t>(i)];
    const double x = (reading.cycles - middle) / scale;
    const double weight = logarithmic ? reading.a : 1.0;
    X.row(i) << weight, weight * x, weight * x * x;
    y[i] = weight * (logarithmic ? std::log(reading.a) : reading.a);
  }
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(X);
  const Eigen::Vector3d b = qr.solve(y);
  const Eigen::Matrix3d R = qr.matrixQR().topRows<3>().triangularView<Eigen::Upper>();
  // R^-T e_1: its square is the entry of (X^T X)^-1 that the slope's variance has (life.16).
  const Eigen::Vector3d contrast =
      R.transpose().triangularView<Eigen::Lower>().solve(Eigen::Vector3d::Unit(1));
  return {.value = b[0],
          .slope = b[1] / scale,
          .slope_error = contrast.norm() / scale,
          .square = (y - X * b).squaredNorm()};
}

MeasuredGrowthRates polynomials(std::span<const CrackReading> readings, std::size_t window,
                                bool logarithmic) {
  MeasuredGrowthRates found;
  const double freedoms = static_cast<double>(window) - 3.0;
  const double quantile = two_sided_student_quantile_95(freedoms);
  double square = 0.0;
  for (std::size_t i = 0; i + window <= readings.size(); ++i) {
    const std::span<const CrackReading> part = readings.subspan(i, window);
    const Parabola p = fit(part, logarithmic);
    const double a = logarithmic ? std::exp(p.value) : p.value;
    // (life.17): the slope of ln a times a.
    const double by_value = logarithmic ? a : 1.0;
    const double deviation = std::sqrt(p.square / freedoms);
    found.points.push_back({.cycles = part[window / 2].cycles,
                            .a = a,
                            .rate = by_value * p.slope,
                            .half_width = quantile * by_value * p.slope_error * deviation});
    square += p.square / freedoms;
  }
  found.scatter = std::sqrt(square / static_cast<double>(found.points.size()));
  return found;
}

MeasuredGrowthRates splines(std::span<const CrackReading> readings) {
  std::vector<double> x, y, weight;
  for (const CrackReading& reading : readings) {
    x.push_back(reading.cycles);
    y.push_back(std::log(reading.a));
    // Readings of constant scatter scatter in ln a by 1/a of it.
    weight.push_back(reading.a);
  }
  const SmoothedCurve curve = fit_smoothing_spline(x, y, weight);
  MeasuredGrowthRates found;
  found.scatter = curve.deviation;
  found.freedoms = curve.freedoms;
  const double quantile =
      two_sided_student_quantile_95(static_cast<double>(x.size()) - curve.freedoms);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double a = std::exp(curve.value[i]);
    found.points.push_back({.cycles = x[i],
                            .a = a,
                            .rate = a * curve.slope[i],
                            .half_width = quantile * a * curve.slope_error[i]});
  }
  return found;
}

} // namespace

MeasuredGrowthRates compute_growth_rates(std::span<const CrackReading> readings,
                                         TestRateMethod method, int window) {
  assert(readings.size() >= model::readings_needed(method, window));
  assert(window >= 5 && window % 2 == 1);
  switch (method) {
  case TestRateMethod::secant:
    return secants(readings);
  case TestRateMethod::e647:
  case TestRateMethod::polynomial:
    return polynomials(readings, static_cast<std::size_t>(window),
                       method == TestRateMethod::polynomial);
  case TestRateMethod::spline:
    return splines(readings);
  }
  return {};
}

} // namespace spricka::life
