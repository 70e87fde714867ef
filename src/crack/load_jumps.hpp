// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/tip_setting.hpp"

#include <vector>

/// Loads that jump or bend within elements round a tip, and what G and K make of them.
namespace spricka::crack {

/// How far G of a domain may be off because tractions jump or bend within sides of its crack faces,
/// or the temperature jumps in it [force/length]; of a half model its half. Quadratic displacements
/// follow neither: what they miss of the energy changes as nodes move past the jump, and what they
/// find there is not the strain that G needs (manual, crack.20, crack.35). Domains inside feel it,
/// too.
double load_jump_G_uncertainty(const TipContext& set, const VirtualExtensionField& field);

/// Part of G that such jumps may make up before G is left to K: a tenth of what two ways to K part
/// by on sound meshes.
constexpr double largest_relative_G_uncertainty = 2e-4;

/// By domain, whether K of it is no measure of the others': loads on faces jump in the elements
/// where q varies, or a temperature jumps in one of the domains. Errors that such a jump makes near
/// it take opposite signs inside and outside and leave the mean alone, which has a bar.
/// `K`: hypot(K1, K2).
std::vector<bool> domains_with_load_jumps(const TipContext& set,
                                          const std::vector<VirtualExtensionField>& fields,
                                          double K);

} // namespace spricka::crack
