// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/pair_points.hpp"

#include "contact/rigid_target.hpp"
#include "contact/segment.hpp"
#include "contact/space/opposite.hpp"
#include "shape/quadrature.hpp"

#include <cmath>

namespace spricka::contact {

namespace {

constexpr int degree = 9; // of the quadrature along a segment

// What a point of a contact edge sees on its normal, or on that of a rigid target.
struct Opposite {
  double eta = 0.0;
  Vec2 normal = Vec2::Zero();
  double gap = 0.0;
  double round_gap = 0.0;
};

// How far along n the circle that the nodes of a surface lie on is from a point of its edges.
double to_circle(const ContactSurface& surface, const Vec2& x, const Vec2& n) {
  if (!surface.circle || !surface.circle->exact) {
    return 0.0;
  }
  const Vec2 d = x - surface.circle->centre;
  const double along = d.normalized().dot(n);
  // Along a ray that is more than 60 degrees off the radius the circle is no measure.
  return std::abs(along) < 0.5 ? 0.0 : (surface.circle->radius - d.norm()) / along;
}

std::optional<Opposite> opposite(const ContactSurface& contact, const model::RigidTarget& rigid,
                                 const MortarSegment& s, double xi) {
  const Vec2 x = point_on(contact.plane.edges[s.contact_edge], xi);
  const std::optional<RigidProjection> foot = normal_projection(rigid, x);
  if (!foot) {
    return std::nullopt;
  }
  const double gap = zero_round_off(foot->gap, x.cwiseAbs().maxCoeff());
  return Opposite{0.0, foot->normal, gap, gap - to_circle(contact, x, foot->normal)};
}

std::optional<Opposite> opposite(const ContactSurface& contact, const ContactSurface& other,
                                 const MortarSegment& s, double xi) {
  const Edge& edge = contact.plane.edges[s.contact_edge];
  const Edge& target = other.plane.edges[s.target_edge];
  const Vec2 x = point_on(edge, xi);
  const Vec2 n = surface_normal(contact, edge, xi);
  const std::optional<double> eta = ray_intersection(target, x, n);
  if (!eta) {
    return std::nullopt;
  }
  const Vec2 y = point_on(target, *eta);
  // (contact.7), and the same between the circles: each surface is moved onto its own.
  const double gap = zero_round_off((y - x).dot(n), x.cwiseAbs().maxCoeff());
  return Opposite{*eta, n, gap, gap - to_circle(contact, x, n) + to_circle(other, y, n)};
}

bool covered_twice(const std::vector<MortarSegment>& segments) {
  // Segments of an edge stand in the order of `from`; neighbours that share a node may overlap by
  // round-off.
  for (std::size_t i = 1; i < segments.size(); ++i) {
    if (segments[i].contact_edge == segments[i - 1].contact_edge &&
        segments[i].from < segments[i - 1].to - 1e-6) {
      return true;
    }
  }
  return false;
}

// False if a point of the segment finds no target: its area would be lost.
template <class Target, class Depth>
bool add_segment(const ContactSurface& contact, const Target& target, const MortarSegment& s,
                 Depth&& depth, std::vector<MortarPoint>& points) {
  const Edge& edge = contact.plane.edges[s.contact_edge];
  for (const auto& [r, weight] : shape::line_rule(degree)) {
    const double xi = 0.5 * ((s.to + s.from) + (s.to - s.from) * r[0]);
    const Vec2 x = point_on(edge, xi);
    const std::optional<Opposite> other = opposite(contact, target, s, xi);
    if (!other) {
      return false;
    }
    MortarPoint p;
    p.facet = s.contact_edge;
    p.target = s.target_edge;
    p.r = {xi, 0.0};
    p.s = {other->eta, 0.0};
    p.x.head<2>() = x;
    p.normal.head<2>() = other->normal;
    p.tangent[0] = {-other->normal.y(), other->normal.x(), 0.0};
    // (contact.12): the area that the point stands for.
    p.weight = 0.5 * (s.to - s.from) * weight * tangent_on(edge, xi).norm() * depth(x);
    p.gap = other->gap;
    p.round_gap = other->round_gap;
    points.push_back(p);
  }
  return true;
}

// Half edges, on which hats are polynomials.
template <class Depth>
void add_whole_edge(const ContactSurface& contact, std::size_t facet, Depth&& depth,
                    std::vector<SurfaceQuadraturePoint>& points) {
  const Edge& edge = contact.plane.edges[facet];
  for (const double half : {-0.5, 0.5}) {
    for (const auto& [r, weight] : shape::line_rule(degree)) {
      const double xi = half + 0.5 * r[0];
      const double w = 0.5 * weight * tangent_on(edge, xi).norm() * depth(point_on(edge, xi));
      points.push_back({facet, {xi, 0.0}, w});
    }
  }
}

template <class Target, class Depth>
MortarPoints find_points(const ContactSurface& contact, const Target& target,
                         std::optional<double> declared_gap, Depth&& depth) {
  MortarPoints all;
  const std::vector<MortarSegment> segments = find_segments(contact, target);
  if (covered_twice(segments)) {
    all.trouble = "the surfaces face each other twice at one place (folded or cornered surfaces "
                  "are not available in this version)";
    return all;
  }
  all.found = !segments.empty();
  for (std::size_t facet = 0; facet < contact.facets.size(); ++facet) {
    add_whole_edge(contact, facet, depth, all.surface);
  }
  for (const MortarSegment& s : segments) {
    if (!add_segment(contact, target, s, depth, all.points)) {
      all.trouble = "the normals of one surface miss the other within a stretch that faces it (too "
                    "strongly curved for its edges?)";
      return all;
    }
  }
  for (MortarPoint& p : all.points) {
    // A declared gap holds for the circles as well: then the two gaps do not differ.
    p.gap = declared_gap.value_or(p.gap);
    p.round_gap = declared_gap.value_or(p.round_gap);
  }
  return all;
}

} // namespace

MortarPoints mortar_points(const ContactSurface& contact, const ContactSurface& target,
                           std::optional<double> declared_gap) {
  return find_points(contact, target, declared_gap,
                     [&](const Vec2& x) { return out_of_plane_depth(contact, target, x); });
}

MortarPoints mortar_points(const ContactSurface& contact, const model::RigidTarget& target,
                           std::optional<double> declared_gap) {
  return find_points(contact, target, declared_gap,
                     [&](const Vec2& x) { return out_of_plane_depth(contact, contact, x); });
}

} // namespace spricka::contact
