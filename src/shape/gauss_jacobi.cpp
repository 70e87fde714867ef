// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/gauss_jacobi.hpp"

#include <cmath>
#include <numbers>

namespace spricka::shape {

namespace {

// Jacobi polynomial P of degree n for the weight (1 - x)^a and its derivative dP.
struct JacobiValue {
  double P = 1.0;
  double dP = 0.0;
};

JacobiValue jacobi(int n, double a, double x) {
  // Three-term recurrence (Abramowitz, Stegun 1964, 22.7) with beta = 0, differentiated alongside.
  double P0 = 1.0;
  double dP0 = 0.0;
  double P = 0.5 * (a + (a + 2.0) * x);
  double dP = 0.5 * (a + 2.0);
  if (n == 0) {
    return {};
  }
  for (int k = 2; k <= n; ++k) {
    const double c = 2.0 * k + a;
    const double scale = 2.0 * k * (k + a) * (c - 2.0);
    const double p = (c - 1.0) * c * (c - 2.0) / scale;
    const double q = (c - 1.0) * a * a / scale;
    const double s = 2.0 * (k + a - 1.0) * (k - 1.0) * c / scale;
    const double P1 = (p * x + q) * P - s * P0;
    const double dP1 = (p * x + q) * dP + p * P - s * dP0;
    P0 = P;
    dP0 = dP;
    P = P1;
    dP = dP1;
  }
  return {P, dP};
}

} // namespace

// Newton's method with the roots already found divided out.
std::vector<QuadraturePoint<1>> gauss_jacobi_rule(int n, double a) {
  std::vector<QuadraturePoint<1>> rule(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5 + 0.5 * a));
    for (int iteration = 0; iteration < 100; ++iteration) {
      const JacobiValue value = jacobi(n, a, x);
      double deflation = 0.0;
      for (int j = 0; j < i; ++j) {
        deflation += 1.0 / (x - rule[static_cast<std::size_t>(j)].r[0]);
      }
      const double step = value.P / (value.dP - value.P * deflation);
      x -= step;
      if (std::abs(step) < 1e-16) {
        break;
      }
    }
    const double dP = jacobi(n, a, x).dP;
    rule[static_cast<std::size_t>(i)] = {Point<1>(x),
                                         std::exp2(a + 1.0) / ((1.0 - x * x) * dP * dP)};
  }
  return rule;
}

} // namespace spricka::shape
