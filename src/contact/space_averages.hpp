// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"

#include <vector>

namespace spricka::contact {

/// Multipliers p [function] of a pair in space averaged to the corners of faces and linear between
/// them (contact_space.6), exact up to the edge where they stand for a field that is linear on flat
/// faces. As they are where a face round a corner is not all covered and `closed` [function], or
/// ends where the pressure has no bound.
base::Vector average_multipliers_to_corners(const PairConstraints& pair, const base::Vector& p,
                                            const std::vector<bool>& closed);

} // namespace spricka::contact
