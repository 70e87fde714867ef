// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/arc.hpp"
#include "contact/constraint.hpp"
#include "contact/node_pressure.hpp"

#include <vector>

/// Places along a contact, counted on the deck's slave whichever side carries the multipliers.
namespace spricka::contact {

/// Whether places are angles about the centre of the slave's circle [rad]; else they are lengths
/// along the slave.
bool uses_angular_coordinate(const PairConstraints& pair);

/// [chain] where its lengths start. They run with the body on their left from the start of the
/// first chain on, across the mouths of cracks; chains that hang on no earlier one follow behind
/// it, in the order of the surface.
std::vector<double> chain_start_lengths(const ContactSurface& surface);

/// Turns theta and arc of the nodes, and the ends of `arc`, from those of the surface with the
/// multipliers into those of the slave: of its nearest point; beyond its
/// first start and last end along the tangent.
void convert_to_slave_coordinates(const PairConstraints& pair, std::vector<NodePressure>& nodes,
                                  SurfaceInterval& arc);

} // namespace spricka::contact
