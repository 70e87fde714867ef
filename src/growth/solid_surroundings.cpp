// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/solid_surroundings.hpp"

#include "mesh/surface/surface_hits.hpp"

#include <cmath>

namespace spricka::growth {

std::optional<SolidBodyQuery::SurfaceAhead>
SolidBodyQuery::surface_ahead(const base::Vec3& x, const base::Vec3& way, base::NetId net) const {
  constexpr double on_it = 1e-7; // of the element: the surface that x lies on is not ahead
  const std::optional<base::ElementId> at = host_.find_element_at(x, net);
  if (!at) {
    return std::nullopt;
  }
  const mesh::SurfaceGeometry& surface =
      host_.body_surface(*at).geometry(mesh::SetBorderPreservation::none);
  for (const mesh::SurfaceHit& hit :
       mesh::intersect_line_with_surface(surface, x, way, surface.diagonal())) {
    if (hit.along > on_it * host_.bounding_ball(*at).edge) {
      return SurfaceAhead{.distance = hit.along,
                          .piece = surface.smooth_piece_index(hit.place.face),
                          .sine = std::abs(hit.place.normal.dot(way))};
    }
  }
  return std::nullopt;
}

std::optional<std::size_t> SolidBodyQuery::surface_piece(const base::Vec3& x,
                                                         const base::Vec3& within,
                                                         base::NetId net) const {
  const std::optional<base::ElementId> at = host_.find_element_at(within, net);
  if (!at) {
    return std::nullopt;
  }
  const mesh::SurfaceGeometry& surface =
      host_.body_surface(*at).geometry(mesh::SetBorderPreservation::none);
  return surface.smooth_piece_index(surface.nearest_place(x).face);
}

bool SolidBodyQuery::is_line_inside(const base::Vec3& one, const base::Vec3& other,
                                    base::NetId net) const {
  constexpr int looks = 16;
  constexpr double off = 0.05; // of the way: coarse facets lie off a round surface
  std::optional<base::ElementId> at = host_.find_element_at(one, net);
  at = at ? at : host_.find_element_at(other, net);
  for (int i = 1; i < looks && at; ++i) {
    const base::Vec3 x = one + (other - one) * i / looks;
    const auto& surface = host_.body_surface(*at).geometry(mesh::SetBorderPreservation::none);
    if (!inside(x, net) && (surface.nearest_place(x).x - x).norm() > off * (other - one).norm()) {
      return false;
    }
  }
  return at.has_value();
}

} // namespace spricka::growth
