// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/segment.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::contact {

EdgeBoundingCircle bounding_circle(const Edge& edge) {
  const Vec2 centre = point_on_edge(edge, 0.0);
  return {centre, std::max((edge.x[0] - centre).norm(), (edge.x[1] - centre).norm())};
}

namespace {

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// The part of the contact edge that the target edge covers, cut at xi = 0 of quadratic edges.
void add_segments(const ContactSurface& contact, const Edge& edge, const Edge& target,
                  const MortarSegment& proto, std::vector<MortarSegment>& out) {
  const std::optional<double> a = normal_projection(contact, edge, target.x[0]);
  const std::optional<double> b = normal_projection(contact, edge, target.x[1]);
  if (!a || !b) {
    return;
  }
  const double from = std::max(std::min(*a, *b), -1.0);
  const double to = std::min(std::max(*a, *b), 1.0);
  if (to - from < shortest_interval) {
    return;
  }
  const double middle = 0.5 * (from + to);
  const Vec2 n = surface_normal(contact, edge, middle);
  const Vec2 x = point_on_edge(edge, middle);
  const std::optional<double> eta = ray_intersection(target, x, n);
  // Judged in the middle of the stretch: sides that look the same way, as those of a thin body, and
  // edges far off are not faced.
  if (!eta || outer_normal(target, std::clamp(*eta, -1.0, 1.0)).dot(n) >= 0.0 ||
      std::abs((point_on_edge(target, *eta) - x).dot(n)) > farthest_opposite * contact.extent) {
    return;
  }
  MortarSegment s = proto;
  if (edge.count == 3 && from < -shortest_interval && to > shortest_interval) {
    s.from = from;
    s.to = 0.0;
    out.push_back(s);
    s.from = 0.0;
    s.to = to;
    out.push_back(s);
  } else {
    s.from = from;
    s.to = to;
    out.push_back(s);
  }
}

} // namespace

std::optional<double> normal_projection(const ContactSurface& surface, const Edge& edge,
                                        const Vec2& point) {
  // Newton on r(xi) = cross(point - x, n) with the normal frozen in the slope; xi = +-1 exact ends
  // are met to round-off, which matters where meshes match.
  const Vec2 chord = edge.x[1] - edge.x[0];
  double xi = 2.0 * (point - edge.x[0]).dot(chord) / chord.squaredNorm() - 1.0;
  xi = std::clamp(xi, -3.0, 3.0);
  for (int i = 0; i < 30; ++i) {
    const Vec2 n = surface_normal(surface, edge, xi);
    const double r = cross(point - point_on_edge(edge, xi), n);
    const double slope = -cross(edge_tangent(edge, xi), n);
    // The normal runs nearly along the edge: it has no foot worth naming.
    if (std::abs(slope) < 1e-3 * edge.length) {
      return std::nullopt;
    }
    // On a circle the normal turns with xi: the slope of the foot scales with distance to centre.
    double scale = 1.0;
    if (surface.circle) {
      scale = (point - surface.circle->centre).norm() / surface.circle->radius;
    }
    const double step = std::clamp(r / (slope * scale), -1.0, 1.0);
    xi -= step;
    if (std::abs(step) < 1e-14) {
      break;
    }
    // Far off either end; callers cut at -1 and 1 and need the side alone.
    if (std::abs(xi) > 6.0) {
      return xi > 0.0 ? 6.0 : -6.0;
    }
  }
  // Where nodes match, segments must be whole edges, not leave slivers of round-off.
  if (std::abs(std::abs(xi) - 1.0) < 1e-9) {
    xi = xi > 0.0 ? 1.0 : -1.0;
  }
  return xi;
}

std::optional<double> ray_intersection(const Edge& target, const Vec2& x, const Vec2& normal) {
  const Vec2 chord = target.x[1] - target.x[0];
  const double slope0 = cross(chord, normal);
  if (std::abs(slope0) < 1e-6 * chord.norm()) {
    return std::nullopt;
  }
  double eta = 2.0 * cross(x - target.x[0], normal) / slope0 - 1.0;
  for (int i = 0; i < 30; ++i) {
    const double r = cross(point_on_edge(target, eta) - x, normal);
    const double slope = cross(edge_tangent(target, eta), normal);
    if (std::abs(slope) < 1e-6 * target.length || std::abs(eta) > 10.0) {
      return std::nullopt;
    }
    const double step = r / slope;
    eta -= step;
    if (std::abs(step) < 1e-14) {
      break;
    }
  }
  return eta;
}

std::vector<MortarSegment> find_mortar_segments(const ContactSurface& contact,
                                                const ContactSurface& target) {
  const std::vector<Edge>& targets = target.plane.edges;
  std::vector<EdgeBoundingCircle> balls;
  balls.reserve(targets.size());
  for (const Edge& edge : targets) {
    balls.push_back(bounding_circle(edge));
  }
  std::vector<MortarSegment> all;
  std::size_t number = 0;
  for (const Edge& edge : contact.plane.edges) {
    const EdgeBoundingCircle own = bounding_circle(edge);
    const auto begin = static_cast<std::ptrdiff_t>(all.size());
    for (std::size_t t = 0; t < targets.size(); ++t) {
      const double reach = own.radius + balls[t].radius + farthest_opposite * contact.extent;
      if ((own.centre - balls[t].centre).norm() <= reach) {
        add_segments(contact, edge, targets[t], {number, t, -1.0, 1.0}, all);
      }
    }
    // Along the edge, so that the order does not depend on how the target is numbered.
    std::sort(all.begin() + begin, all.end(), [](const MortarSegment& a, const MortarSegment& b) {
      return std::pair(a.from, a.target_edge) < std::pair(b.from, b.target_edge);
    });
    ++number;
  }
  return all;
}

} // namespace spricka::contact
