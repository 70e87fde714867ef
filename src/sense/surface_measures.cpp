// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/surface_measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace spricka::sense {

namespace {

constexpr double corner = 0.6; // turns of more between edges are no facets [rad]

// How far edges between their nodes leave the circle that the nodes lie on.
double facet_of(const contact::PlanarEdgeChains& plane, const contact::SurfaceCircle& circle) {
  double most = 0.0;
  for (const contact::Edge& edge : plane.edges) {
    for (const double xi : {-0.5, 0.0, 0.5}) {
      const base::Vec2 x = contact::point_on_edge(edge, xi);
      most = std::max(most, std::abs((x - circle.centre).norm() - circle.radius));
    }
  }
  return most;
}

// How far straight edges leave the curve that they stand for: half a chord times half the turn
// between two of them, halved.
double error_of_edges(const contact::ContactSurface& surface) {
  double most = surface.circle ? facet_of(surface.plane, *surface.circle) : 0.0;
  for (const contact::EdgeChain& chain : surface.plane.chains) {
    const std::span<const contact::Edge> edges = surface.plane.edges_of_chain(chain);
    const std::size_t n = edges.size();
    for (std::size_t e = 0; e < n && n > 1; ++e) {
      if (e + 1 == n && !chain.closed) {
        continue;
      }
      const contact::Edge& a = edges[e];
      const contact::Edge& b = edges[(e + 1) % n];
      const base::Vec2 s = contact::edge_tangent(a, 1.0);
      const base::Vec2 t = contact::edge_tangent(b, -1.0);
      const double turn = std::abs(std::atan2(s.x() * t.y() - s.y() * t.x(), s.dot(t)));
      most = std::max(most, turn < corner ? 0.125 * turn * std::max(a.length, b.length) : 0.0);
    }
  }
  return most;
}

// How far the faces of a surface leave the round shape that their nodes lie on: flat ones, and
// curved ones between their nodes. Looked at in the middles of the triangles between nodes and of
// their sides.
double error_of_faces(const contact::FacetSurface& surface) {
  constexpr std::array<std::array<double, 3>, 4> middles{
      {{1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0}, {0.5, 0.5, 0.0}, {0.0, 0.5, 0.5}, {0.5, 0.0, 0.5}}};
  double most = 0.0;
  for (const contact::HatElement& triangle : surface.elements) {
    const std::optional<contact::AnalyticShape>& round = surface.analytic_shape(triangle.facet);
    if (!round) {
      continue;
    }
    const geometry::ElementSide& face = surface.facets[triangle.facet];
    for (const std::array<double, 3>& at : middles) {
      contact::Vec2 r = contact::Vec2::Zero();
      for (std::size_t i = 0; i < at.size(); ++i) {
        r += at[i] * face.node_local_coordinates(triangle.node[i]);
      }
      const base::Vec3 x = face.position(r);
      most = std::max(most, std::abs(contact::signed_distance(*round, x)));
    }
  }
  return most;
}

} // namespace

double faceting_error(const contact::ContactSurface& surface) {
  return std::max(error_of_edges(surface), error_of_faces(surface));
}

std::optional<double> round_surface_radius(const contact::ContactSurface& surface) {
  if (surface.circle) {
    return surface.circle->radius;
  }
  const bool one = surface.rounds.size() == 1 && surface.rounds.front();
  return one && surface.rounds.front()->kind != contact::AnalyticShapeKind::plane
             ? std::optional(surface.rounds.front()->radius)
             : std::nullopt;
}

double surface_radius_or_half_extent(const contact::ContactSurface& surface) {
  return round_surface_radius(surface).value_or(0.5 * surface.extent);
}

std::vector<double> facet_lengths_or_areas(const contact::ContactSurface& surface) {
  std::vector<double> all;
  for (const geometry::ElementSide& facet : surface.facets) {
    all.push_back(contact::facet_length_or_area(facet));
  }
  return all;
}

base::Vec3 facet_midpoint(const contact::ContactSurface& surface, std::size_t facet) {
  const geometry::ElementSide& side = surface.facets[facet];
  return side.position(side.domain_centre());
}

} // namespace spricka::sense
