// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/results.hpp"

#include <string>

/// Results at places of a contact surface that $CHECK asks for.
namespace spricka::program {

/// A value (pressure) at the place of the surface that is nearest to a point, between two nodes
/// that follow one another. Throws Missing where there is no surface.
double pressure_near(const results::ContactResult& contact, double results::ContactPoint::*value,
                     const base::Vec2& x);

/// ARC.PART.FROM or ARC.PART.TO: an end of the closed part of that number, along the surface.
/// Throws Missing where there is no such part.
double end_of_part(const results::ContactResult& contact, const std::string& quantity,
                   double number);

} // namespace spricka::program
