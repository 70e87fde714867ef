// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/surface_measures.hpp"

#include "contact/segment.hpp"
#include "contact/space/sight.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace spricka::sense {

namespace {

constexpr double corner = 0.6; // turns of more between edges are no facets [rad]

// How far straight edges leave the curve that they stand for: half a chord times half the turn
// between two of them, halved.
double facet_of(const contact::Surface& surface) {
  double most = 0.0;
  for (const contact::EdgeChain& chain : surface.plane.chains) {
    const std::span<const contact::Edge> edges = surface.plane.of(chain);
    const std::size_t n = edges.size();
    for (std::size_t e = 0; e < n && n > 1; ++e) {
      if (e + 1 == n && !chain.closed) {
        continue;
      }
      const contact::Edge& a = edges[e];
      const contact::Edge& b = edges[(e + 1) % n];
      const base::Vec2 s = contact::tangent_on(a, 1.0);
      const base::Vec2 t = contact::tangent_on(b, -1.0);
      const double turn = std::abs(std::atan2(s.x() * t.y() - s.y() * t.x(), s.dot(t)));
      most = std::max(most, turn < corner ? 0.125 * turn * std::max(a.length, b.length) : 0.0);
    }
  }
  return most;
}

// The same of flat faces on round shapes.
double facet_of(const contact::SpaceSurface& surface) {
  double most = 0.0;
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    if (const std::optional<contact::Round>& round = surface.round_of(f)) {
      const base::ElementType shape = surface.faces[f].shape;
      const base::Vec3 centre = contact::point_on(surface.faces[f], contact::centre_r(shape)).x;
      most = std::max(most, std::abs(contact::distance_to(*round, centre)));
    }
  }
  return most;
}

double gap_at(const contact::Surface& surface, const contact::Edge& edge,
              const contact::Surface& target, const contact::Segment& s) {
  const double xi = 0.5 * (s.from + s.to);
  const base::Vec2 x = contact::point_on(edge, xi);
  const base::Vec2 n = contact::surface_normal(surface, edge, xi);
  const contact::Edge& other = target.plane.edges[s.target_edge];
  const std::optional<double> eta = contact::hit_on(other, x, n);
  return eta ? (contact::point_on(other, *eta) - x).dot(n) : 0.0;
}

} // namespace

double facets_of(const contact::Surface& surface) {
  return surface.space.faces.empty() ? facet_of(surface) : facet_of(surface.space);
}

std::optional<double> radius_of(const contact::Surface& surface) {
  if (surface.circle) {
    return surface.circle->radius;
  }
  const bool one = surface.space.rounds.size() == 1 && surface.space.rounds.front();
  return one && surface.space.rounds.front()->kind != contact::RoundKind::plane
             ? std::optional(surface.space.rounds.front()->radius)
             : std::nullopt;
}

double size_of(const contact::Surface& surface) {
  return radius_of(surface).value_or(0.5 * surface.extent);
}

std::vector<SeenPart> seen_parts(const contact::Surface& surface, const contact::Surface& target,
                                 const std::vector<double>& measure) {
  std::vector<SeenPart> parts;
  if (!surface.space.faces.empty()) {
    const contact::Sighting sighting(surface.space, target.space);
    for (const contact::SurfaceTriangle& t : surface.space.triangles) {
      for (const contact::SightPoint& p : sighting.see(t).points) {
        parts.push_back({t.face, p.weight / measure[t.face], p.gap});
      }
    }
    return parts;
  }
  for (const contact::Segment& s : contact::find_segments(surface, target)) {
    // Coordinates of an edge run from -1 to 1: half the stretch is its part of the edge.
    parts.push_back({s.contact_edge, 0.5 * (s.to - s.from),
                     gap_at(surface, surface.plane.edges[s.contact_edge], target, s)});
  }
  return parts;
}

std::vector<double> measures(const contact::Surface& surface) {
  std::vector<double> all;
  for (const contact::Edge& edge : surface.plane.edges) {
    all.push_back(edge.length);
  }
  for (const contact::SolidFace& face : surface.space.faces) {
    all.push_back(contact::area_of(face));
  }
  return all;
}

base::Vec3 middle_of(const contact::Surface& surface, std::size_t facet) {
  if (!surface.space.faces.empty()) {
    const contact::SolidFace& face = surface.space.faces[facet];
    return contact::point_on(face, contact::centre_r(face.shape)).x;
  }
  const base::Vec2 x = contact::point_on(surface.plane.edges[facet], 0.0);
  return {x.x(), x.y(), 0.0};
}

} // namespace spricka::sense
