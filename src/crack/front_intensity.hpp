// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/front_rows.hpp"
#include "crack/stress_intensity.hpp"

#include <vector>

/// K and T along a front in space from converged displacements by virtual crack extension.
namespace spricka::crack {

struct FrontIntensityRequest {
  bool opening = false; ///< K from the opening of the crack's faces as well
  FrontTermSwitches terms{};
};

/// K1, K2, K3, G and T at each point of a front from nodal displacements u [3 * node]: products of
/// the points' extensions with configurational forces of u with itself and with auxiliary fields
/// (manual, crack_space.6 to crack_space.12), per length of the front. A point without a domain has
/// zeros and no domains. The E' is that of plane strain: G = (K1^2 + K2^2) / E' + K3^2 / (2 mu).
std::vector<StressIntensity> front_intensity(const model::Model& model,
                                             const mesh::CrackedMesh& cracked,
                                             const mesh::CrackFront& front,
                                             const FrontExtensions& fields,
                                             const FrontIntensityRequest& request,
                                             const base::Vector& u, const FrontLoads& loads);

/// Fills smooth values and those from inside (crack_space.15, crack_space.16) from K1, K2 and K3 of
/// the points that have domains: linear in K.
void smooth_along(const mesh::CrackFront& front, const FrontExtensions& fields,
                  std::vector<StressIntensity>& result);

} // namespace spricka::crack
