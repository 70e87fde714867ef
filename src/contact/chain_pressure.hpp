// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/row_values.hpp"

namespace spricka::contact {

/// recover_pressure() of a pair in the plane: its nodes chain by chain and its arc. Pressures of
/// NODE pairs from the forces on nodes with the surface mass, C p = R, those of SEGMENT pairs from
/// their multipliers. The area of the part in contact.
double recover_chain_pressure(const PairConstraints& pair, const ContactRowValues& rows,
                              const ContactSideNodalForces& force, PairPressure& result);

} // namespace spricka::contact
