// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/tip_intensity.hpp"

#include <vector>

/// K and T along a front from converged displacements by virtual crack extension; in the plane of
/// its one point, the tip.
namespace spricka::crack {

/// K, G and T at each point of a front from nodal displacements u [dim * node]: products of the
/// points' extensions with configurational forces of u with itself and with auxiliary fields, in
/// the plane see tip_intensity (manual, crack.11 to crack.26), in space per length of the front
/// (manual, crack_space.6 to crack_space.12). A point without a domain has zeros and no domains. In
/// space E' is that of plane strain: G = (K1^2 + K2^2) / E' + K3^2 / (2 mu).
std::vector<StressIntensity> front_intensity(const model::Model& model,
                                             const mesh::CrackedMesh& cracked,
                                             const mesh::CrackFront& front,
                                             const FrontIntegralDomains& domains,
                                             const FrontIntensityOptions& request,
                                             const base::Vector& u, const FrontLoads& loads);

/// Fills, in space, smooth values and those from inside (crack_space.15, crack_space.16) from K1,
/// K2 and K3 of the points that have domains: linear in K.
void smooth_intensity_along_front(const mesh::CrackFront& front, const FrontIntegralDomains& fields,
                                  std::vector<StressIntensity>& result);

} // namespace spricka::crack
