// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/surface.hpp"

#include <cstddef>
#include <optional>
#include <vector>

/// What contact surfaces measure, in the plane and in space.
namespace spricka::sense {

/// How far straight edges or flat faces leave the curve or the round shape that they stand for
/// [length].
double faceting_error(const contact::ContactSurface& surface);

/// The radius of a surface that is one circle, cylinder, cone or sphere [length].
std::optional<double> round_surface_radius(const contact::ContactSurface& surface);
/// That radius, of others half of the extent [length].
double surface_radius_or_half_extent(const contact::ContactSurface& surface);

/// Lengths of edges, areas of faces, by facet.
std::vector<double> facet_lengths_or_areas(const contact::ContactSurface& surface);
/// The place at the middle of a facet's local coordinates, of an edge in the plane at xi = 0.
base::Vec3 facet_midpoint(const contact::ContactSurface& surface, std::size_t facet);

} // namespace spricka::sense
