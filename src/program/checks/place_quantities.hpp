// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/results.hpp"

#include <cstddef>

/// Results at places of a contact surface that $CHECK asks for.
namespace spricka::program {

/// A value (pressure) at the place of the surface that is nearest to a point, between two nodes
/// that follow one another; in space at the nearest node. Throws Missing where there is no surface.
double contact_value_near(const results::ContactResult& contact,
                          double results::ContactPoint::*value, const base::Vec3& x);

/// ARC.PART.FROM (end 0) or ARC.PART.TO (1): of the closed part of that number, along the surface.
/// Throws Missing where there is no such part.
double contact_arc_end(const results::ContactResult& contact, double number, std::size_t end);

} // namespace spricka::program
