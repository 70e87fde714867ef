// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <optional>
#include <vector>

/// K and T at a point of a front, in the plane its tip, and of its domains.
namespace spricka::crack {

/// The values of one domain.
struct DomainIntensity {
  int rings = 0;
  double K1 = 0.0, K2 = 0.0; ///< [stress * length^0.5]
  double K3 = 0.0;           ///< in space
  double G = 0.0; ///< from the displacement [force/length]; NaN: a temperature jumps in elements
  double T = 0.0; ///< [stress]
};

/// What a point of a front in space has beside the values of a tip.
struct SmoothedFrontIntensity {
  /// K1, K2, K3 by a smooth curve through the values of all points (manual, crack_space.15).
  std::array<double, 3> smooth{};
  /// Of a point at the surface: K1, K2, K3 as those farther inside go on to it (crack_space.16).
  std::optional<std::array<double, 3>> from_inside;
};

struct StressIntensity {
  double K1 = 0.0, K2 = 0.0, G = 0.0; ///< means over the domains
  double K3 = 0.0;                    ///< the same, in space
  double T = 0.0;           ///< stress along the crack at the tip that K leaves, its mean [stress]
  double G_from_K = 0.0;    ///< (K1^2 + K2^2) / E', in space with K3^2 / 2 mu
  double spread = 0.0;      ///< (max - min of K1) / hypot(K1, K2); in space see crack_space.14
  double E_effective = 0.0; ///< E' that belongs to the K printed
  /// The tip lies between two materials: its stresses oscillate, there is no K1, K2 (all 0), only
  /// G.
  bool two_materials = false;
  std::vector<DomainIntensity> domains;
  std::optional<double> shift_error;            ///< G by finite shift over analytic G, minus 1
  std::optional<std::array<double, 3>> opening; ///< K1, K2, K3 by the opening of the crack faces
  std::optional<SmoothedFrontIntensity> front;  ///< in space
};

/// G [energy/length^2] of stress intensity factors K1, K2, K3: K1^2 / E' + K2^2 / E' + K3^2 / 2 mu.
double energy_release_rate(double E_effective, double mu, const std::array<double, 3>& K);

/// From the domains of a point, one at least, its means, G of K and spread: the largest range of
/// the first `compared` modes over sqrt(E' G of K). Two materials and E' are known.
void summarise_domain_intensities(double mu, std::size_t compared, StressIntensity& result);

} // namespace spricka::crack
