// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/results.hpp"

#include <array>
#include <string>
#include <vector>

namespace spricka::analysis {

/// All closed parts [from, to] of a contact surface, one after another along it, counted as its arc
/// is (which is the longest of them); empty where nothing is closed. Ends by (contact.11).
std::vector<std::array<double, 2>> closed_contact_parts(const results::ContactResult& contact);

/// Whether a place along a straight slave lies between two pieces of the surface with the
/// pressures: nothing is opposite.
bool is_between_surface_pieces(const results::ContactResult& contact, double place);

/// Names them, where there are several; else empty.
std::string describe_closed_parts(const results::ContactResult& contact);

} // namespace spricka::analysis
