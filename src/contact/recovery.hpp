// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"
#include "contact/pair_pressure.hpp"

#include <vector>

/// Pressures from contact forces, C p = R with the surface mass C (Ansell and Fredriksson,
/// equations 6 to 8; manual, contact.9), lumped or consistent. SEGMENT pairs have a pressure of
/// their own, the multiplier, which is never negative: it stands for the consistent one. No
/// pressure of a contact that can part is negative.
namespace spricka::contact {

/// Recovers the pressures of a pair from lambda [normal rows, then tangent rows] [stress], weighted
/// gap [normal rows] and closed [normal rows]. `may_pull`: a bonded pair, whose pressures may be
/// negative.
PairPressure recover_pressure(const PairConstraints& pair, const base::Vector& lambda,
                              const base::Vector& gap, const std::vector<bool>& closed,
                              bool may_pull = false);

} // namespace spricka::contact
