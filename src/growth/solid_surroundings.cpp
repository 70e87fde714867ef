// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/solid_surroundings.hpp"

#include "mesh/surface/surface_hits.hpp"

#include <cmath>

namespace spricka::growth {

std::optional<SolidSurroundings::Ahead>
SolidSurroundings::to_surface(const base::Vec3& x, const base::Vec3& way, base::NetId net) const {
  constexpr double on_it = 1e-7; // of the element: the surface that x lies on is not ahead
  const std::optional<base::ElementId> at = host_.element_at(x, net);
  if (!at) {
    return std::nullopt;
  }
  const mesh::SurfaceGeometry& surface = host_.surface(*at).geometry(mesh::Borders::none);
  for (const mesh::SurfaceHit& hit : mesh::hits(surface, x, way, surface.extent())) {
    if (hit.along > on_it * host_.extent(*at).edge) {
      return Ahead{.distance = hit.along,
                   .piece = surface.piece(hit.place.face),
                   .sine = std::abs(hit.place.normal.dot(way))};
    }
  }
  return std::nullopt;
}

std::optional<std::size_t>
SolidSurroundings::piece_at(const base::Vec3& x, const base::Vec3& within, base::NetId net) const {
  const std::optional<base::ElementId> at = host_.element_at(within, net);
  if (!at) {
    return std::nullopt;
  }
  const mesh::SurfaceGeometry& surface = host_.surface(*at).geometry(mesh::Borders::none);
  return surface.piece(surface.nearest(x).face);
}

} // namespace spricka::growth
