// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

/// Where a crack grows to under K1 and K2, and the K it meets there.
namespace spricka::crack {

enum class KinkCriterion {
  hoop,   ///< the largest hoop stress (Erdogan and Sih 1963)
  k2_zero ///< K2 = 0 at the tip of the kink (Amestoy and Leblond 1992)
};

/// The angle of a kink against the crack [rad], positive to its left; K2 > 0 turns it right. 0
/// where neither K1 > 0 nor K2 opens anything.
///   hoop: -2 atan(2 K2 / (K1 + sqrt(K1^2 + 8 K2^2))), at most 70.53 degrees
///   k2_zero: the root of F21 K1 + F22 K2, at most 77.33 degrees (manual, growth.7, growth.9)
double kink_angle(KinkCriterion criterion, double K1, double K2);

/// K1 at the tip of an infinitely short kink at this angle is first * K1 + second * K2 of the crack
/// before it: by the hoop stress (growth.8), or by F11 and F12.
base::Vec2 kinked_K1_factors(KinkCriterion criterion, double angle);

/// F11 F12; F21 F22 by Amestoy and Leblond's expansion to m^20, m = angle/pi, good to some 1e-5 up
/// to 80 degrees: K at the tip of the kink is F times K of the crack before it.
struct KinkFunctions {
  double F11 = 1.0, F12 = 0.0, F21 = 0.0, F22 = 1.0;
};
/// The kink functions at an angle [rad] between crack and kink.
KinkFunctions kink_functions(double angle);

} // namespace spricka::crack
