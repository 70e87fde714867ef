// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/row_values.hpp"

namespace spricka::contact {

/// recover_pressure() of a pair in space, function by function. p_consistent is the multiplier,
/// force over the function's area. p_lumped is that averaged to corners where all faces round a
/// corner are covered and closed, and linear between corners: multipliers of faces of second order
/// go up and down by a few per mille about it. Elsewhere, as where contact ends, it is the
/// multiplier. The area of the part in contact.
double recover_solid_pair_pressure(const PairConstraints& pair, const ContactRowValues& rows,
                                   const ContactSideNodalForces& force, PairPressure& result);

} // namespace spricka::contact
