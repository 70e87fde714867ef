// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/direction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace spricka::crack {

namespace {

constexpr double P = std::numbers::pi;
constexpr double P2 = P * P;
constexpr double P3 = P2 * P;
constexpr double P4 = P2 * P2;
constexpr double P5 = P4 * P;
constexpr double P6 = P3 * P3;

// Amestoy and Leblond 1992, section 6: powers of m = angle/pi; even ones in F11 and F22, odd ones
// in F12 and F21.
constexpr std::array f11{1.0,
                         -3.0 * P2 / 8.0,
                         P2 - 5.0 * P4 / 128.0,
                         P2 / 9.0 - 11.0 * P4 / 72.0 + 119.0 * P6 / 15360.0,
                         5.07790,
                         -2.88312,
                         -0.0925,
                         2.996,
                         -4.059,
                         1.63,
                         4.1};
constexpr std::array f12{-3.0 * P / 2.0,
                         10.0 * P / 3.0 + P3 / 16.0,
                         -2.0 * P - 133.0 * P3 / 180.0 + 59.0 * P5 / 1280.0,
                         12.313906,
                         -7.32433,
                         1.5793,
                         4.0216,
                         -6.915,
                         4.21,
                         4.56};
constexpr std::array f21{P / 2.0,
                         -4.0 * P / 3.0 - P3 / 48.0,
                         -2.0 * P / 3.0 + 13.0 * P3 / 30.0 - 59.0 * P5 / 3840.0,
                         -6.176023,
                         4.44112,
                         -1.5340,
                         -2.0700,
                         4.684,
                         -3.95,
                         -1.32};
constexpr std::array f22{1.0,
                         -4.0 - 3.0 * P2 / 8.0,
                         8.0 / 3.0 + 29.0 * P2 / 18.0 - 5.0 * P4 / 128.0,
                         -32.0 / 15.0 - 4.0 * P2 / 9.0 - 1159.0 * P4 / 7200.0 +
                             119.0 * P6 / 15360.0,
                         10.58254,
                         -4.78511,
                         -1.8804,
                         7.280,
                         -7.591,
                         0.25,
                         12.5};

// c0 + c1 m^2 + c2 m^4 + ..
double in_squares(std::span<const double> coefficient, double m) {
  double sum = 0.0;
  for (std::size_t i = coefficient.size(); i-- > 0;) {
    sum = sum * m * m + coefficient[i];
  }
  return sum;
}

double hoop_angle(double K1, double K2) {
  // (growth.7). Zero where there is no K2 and K1 does not open the faces: no angle then.
  const double below = K1 + std::sqrt(K1 * K1 + 8.0 * K2 * K2);
  return below > 0.0 ? -2.0 * std::atan(2.0 * K2 / below) : 0.0;
}

// F21 K1 + F22 K2 changes its sign once between no kink and that of pure mode 2.
double k2_zero_angle(double K1, double K2) {
  if (K2 == 0.0) {
    return 0.0;
  }
  // The kink turns against the sign of K2; its size is looked for (growth.9).
  const double side = K2 > 0.0 ? -1.0 : 1.0;
  const auto second = [&](double turn) {
    const KinkFunctions F = kink_functions(side * turn);
    // A K1 below zero opens nothing: what is left is pure mode 2.
    return (F.F21 * std::max(K1, 0.0) + F.F22 * K2) * -side;
  };
  double low = 0.0;
  double high = 1.36; // just beyond that of pure mode 2
  // To round-off of the angle.
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (second(middle) > 0.0 ? low : high) = middle;
  }
  return side * 0.5 * (low + high);
}

} // namespace

KinkFunctions kink_functions(double angle) {
  const double m = angle / P;
  return {.F11 = in_squares(f11, m),
          .F12 = m * in_squares(f12, m),
          .F21 = m * in_squares(f21, m),
          .F22 = in_squares(f22, m)};
}

double kink_angle(KinkCriterion criterion, double K1, double K2) {
  return criterion == KinkCriterion::hoop ? hoop_angle(K1, K2) : k2_zero_angle(K1, K2);
}

base::Vec2 kinked_K1_factors(KinkCriterion criterion, double angle) {
  if (criterion == KinkCriterion::k2_zero) {
    const KinkFunctions F = kink_functions(angle);
    return {F.F11, F.F12};
  }
  // (growth.8).
  const double c = std::cos(0.5 * angle);
  return {c * c * c, -3.0 * c * c * std::sin(0.5 * angle)};
}

} // namespace spricka::crack
