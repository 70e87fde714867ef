// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/life_curve.hpp"

#include "life/no_value.hpp"
#include "life/root.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace spricka::life {

namespace {

constexpr double k_cycles_tolerance = 1e-12;
// Of an estimate three digits will do.
constexpr double k_error_tolerance = 1e-3;

std::vector<double> logarithms(const std::vector<double>& values) {
  std::vector<double> logs;
  for (const double value : values) {
    assert(value > 0.0);
    logs.push_back(std::log(value));
  }
  return logs;
}

std::vector<double> without(std::vector<double> values, std::size_t i) {
  values.erase(values.begin() + static_cast<std::ptrdiff_t>(i));
  return values;
}

// The integral of f(ln a) over ln a from a0 to a1, by the stretches between stations.
template <class F>
Integral over_intervals(const std::vector<double>& a, std::pair<double, double> ends, const F& f,
                        double tolerance) {
  Integral sum;
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    const double begin = std::max(ends.first, a[i]);
    const double end = std::min(ends.second, a[i + 1]);
    if (begin < end) {
      const Integral part = integrate(f, std::log(begin), std::log(end), tolerance);
      sum.value += part.value;
      sum.error += part.error;
    }
  }
  return sum;
}

} // namespace

LifeCurve::LifeCurve(const std::vector<double>& a, const std::vector<double>& rate)
    : a_(a), log_rate_(logarithms(a), logarithms(rate)) {
  const std::vector<double> x = logarithms(a);
  const std::vector<double> y = logarithms(rate);
  for (std::size_t i = 1; i + 1 < a.size(); ++i) {
    // Inner stations only: without an end the spline would have to go on beyond its points.
    without_.emplace_back(without(x, i), without(y, i));
  }
  at_.push_back(0.0);
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    at_.push_back(at_.back() + cycles(a[i], a[i + 1]));
  }
}

bool LifeCurve::within(double a0, double a1) const {
  return a0 >= a_.front() && a0 <= a1 && a1 <= a_.back();
}

double LifeCurve::growth_rate(double a) const {
  return within(a, a) ? std::exp(log_rate_.value(std::log(a))) : no_value;
}

// (life.13) over x = ln a.
Integral LifeCurve::integrated_cycles(double a0, double a1) const {
  const auto cycles_by_log = [&](double x) { return std::exp(x - log_rate_.value(x)); };
  return over_intervals(a_, {a0, a1}, cycles_by_log, k_cycles_tolerance);
}

double LifeCurve::cycles(double a0, double a1) const {
  return within(a0, a1) ? integrated_cycles(a0, a1).value : no_value;
}

double LifeCurve::length_at(double N) const {
  if (!(N >= 0.0 && N <= at_.back())) {
    return no_value;
  }
  const auto above = std::upper_bound(at_.begin() + 1, at_.end() - 1, N);
  const auto i = static_cast<std::size_t>(above - at_.begin());
  // As a part of the interval's cycles: a function of the size of 1, whatever the life.
  const double part = (N - at_[i - 1]) / (at_[i] - at_[i - 1]);
  const auto excess = [&](double a) { return cycles(a_[i - 1], a) / (at_[i] - at_[i - 1]) - part; };
  // at the last station round-off may leave N a little behind
  return root_of_increasing_function(excess, a_[i - 1], a_[i]).value_or(a_[i]);
}

// What log_rate_ changes by at x when a station next to it is left out: the larger of two.
double LifeCurve::miss(double x) const {
  const std::size_t before = log_rate_.locate(x).interval;
  double largest = 0.0;
  for (const std::size_t station : {before, before + 1}) {
    if (station > 0 && station < log_rate_.interval_count()) {
      largest = std::max(largest, std::fabs(without_[station - 1].value(x) - log_rate_.value(x)));
    }
  }
  return largest;
}

double LifeCurve::cycles_error(double a0, double a1) const {
  if (!within(a0, a1)) {
    return no_value;
  }
  if (without_.empty()) {
    return std::numeric_limits<double>::infinity();
  }
  // (life.14): rates taken to be too large by exp(miss) everywhere.
  const auto missed_by_log = [&](double x) {
    return std::expm1(miss(x)) * std::exp(x - log_rate_.value(x));
  };
  const Integral missed = over_intervals(a_, {a0, a1}, missed_by_log, k_error_tolerance);
  return missed.value + missed.error + integrated_cycles(a0, a1).error;
}

} // namespace spricka::life
