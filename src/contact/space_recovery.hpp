// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"
#include "contact/pair_pressure.hpp"

namespace spricka::contact {

/// recover_pressure() of a pair in space. p_consistent is the multiplier, force over the function's
/// area. p_lumped is that averaged to corners where all faces round a corner are covered and
/// closed, and linear between corners: multipliers of faces of second order go up and down by
/// a few per mille about it. Elsewhere, as where contact ends, it is the multiplier.
PairPressure recover_space_pressure(const PairConstraints& pair, const base::Vector& lambda,
                                    const base::Vector& gap, const std::vector<bool>& closed);

} // namespace spricka::contact
