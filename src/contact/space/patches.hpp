// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/space/hat_elements.hpp"

#include <cstddef>
#include <vector>

namespace spricka::contact {

/// [face] number of the smooth part of the surface that a face belongs to, counted in the order of
/// the faces. Parts end at edges where normals turn by more than 30 degrees: there a node has two
/// normals, and a pressure for each. Faces that share a corner only belong together through others.
std::vector<std::size_t> smooth_part_numbers(const std::vector<geometry::ElementSide>& faces);

} // namespace spricka::contact
