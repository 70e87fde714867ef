// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/stress_intensity.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace spricka::crack {

double energy_release_rate(double E_effective, double mu, const std::array<double, 3>& K) {
  return (K[0] * K[0] + K[1] * K[1]) / E_effective + K[2] * K[2] / (2.0 * mu);
}

void summarise_domain_intensities(double mu, std::size_t compared, StressIntensity& result) {
  const auto count = static_cast<double>(result.domains.size());
  std::array<double, 3> low{};
  std::array<double, 3> high{};
  double with_G = 0.0;
  for (std::size_t d = 0; d < result.domains.size(); ++d) {
    const DomainIntensity& value = result.domains[d];
    result.K1 += value.K1 / count;
    result.K2 += value.K2 / count;
    result.K3 += value.K3 / count;
    // Domains that tell no G are left out of its mean; where none tells one it is that of K.
    with_G += std::isnan(value.G) ? 0.0 : 1.0;
    result.G += std::isnan(value.G) ? 0.0 : value.G;
    result.T += value.T / count;
    const std::array<double, 3> K{value.K1, value.K2, value.K3};
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = d == 0 ? K[k] : std::min(low[k], K[k]);
      high[k] = d == 0 ? K[k] : std::max(high[k], K[k]);
    }
  }
  const double of_K =
      energy_release_rate(result.E_effective, mu, {result.K1, result.K2, result.K3});
  const double K = std::sqrt(result.E_effective * of_K);
  for (std::size_t k = 0; k < compared && K > 0.0; ++k) {
    result.spread = std::max(result.spread, (high[k] - low[k]) / K);
  }
  result.G /= std::max(with_G, 1.0);
  result.G_from_K = result.two_materials ? result.G : of_K;
  result.G = with_G == 0.0 ? result.G_from_K : result.G;
}

} // namespace spricka::crack
