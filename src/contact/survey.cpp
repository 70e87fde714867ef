// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/survey.hpp"

#include "contact/rigid_target.hpp"
#include "contact/segment.hpp"
#include "contact/space/rigid_round.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace spricka::contact {

namespace {

// Both ends without weight, then Gauss points of degree 5.
constexpr std::array<double, 5> sample_r{-1.0, 1.0, -0.7745966692414834, 0.0, 0.7745966692414834};
constexpr std::array<double, 5> sample_w{0.0, 0.0, 5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};

double angle_between(const Vec2& a, const Vec2& b) {
  return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
}

struct Glance {
  double gap = 0.0;
  double angle = 0.0; ///< between one normal and the other reversed
};

// Samples the segments; `look(segment, edge, xi)` tells what is seen there, if anything.
template <class Look>
GapSurvey sample(const ContactSurface& from, const std::vector<MortarSegment>& segments,
                 Look&& look) {
  const std::vector<Edge>& edges = from.plane.edges;
  GapSurvey found;
  found.edges = edges.size();
  for (const Edge& edge : edges) {
    found.length += edge.length;
  }
  std::vector<bool> faces(edges.size(), false);
  bool first = true;
  for (const MortarSegment& s : segments) {
    const Edge& edge = edges[s.contact_edge];
    for (std::size_t i = 0; i < sample_r.size(); ++i) {
      const double xi = 0.5 * ((s.to + s.from) + (s.to - s.from) * sample_r[i]);
      const std::optional<Glance> projection = look(s, edge, xi);
      if (!projection) {
        continue;
      }
      faces[s.contact_edge] = true;
      const double gap = projection->gap;
      const double w = 0.5 * (s.to - s.from) * sample_w[i] * tangent_on(edge, xi).norm();
      found.seen += w;
      found.gap_mean += w * gap;
      found.gap_low = first ? gap : std::min(found.gap_low, gap);
      found.gap_high = first ? gap : std::max(found.gap_high, gap);
      found.angle_high = std::max(found.angle_high, projection->angle);
      first = false;
    }
  }
  found.facing = static_cast<std::size_t>(std::count(faces.begin(), faces.end(), true));
  found.gap_mean = found.seen > 0.0 ? found.gap_mean / found.seen : 0.0;
  found.seen = std::min(found.seen, found.length); // round-off
  return found;
}

template <class See> GapSurvey survey_space(const SpaceSurface& from, See&& see) {
  GapSurvey found;
  found.edges = from.faces.size();
  std::vector<bool> faces(from.faces.size(), false);
  bool first = true;
  for (const SurfaceTriangle& t : from.triangles) {
    const ProjectedTriangle projection = see(t);
    found.length += projection.whole.sum();
    for (const ProjectionPoint& p : projection.points) {
      faces[t.face] = true;
      found.seen += p.weight;
      found.gap_mean += p.weight * p.gap;
      found.gap_low = first ? p.gap : std::min(found.gap_low, p.gap);
      found.gap_high = first ? p.gap : std::max(found.gap_high, p.gap);
      found.angle_high = std::max(found.angle_high, std::acos(std::min(1.0, p.turn)));
      first = false;
    }
  }
  found.facing = static_cast<std::size_t>(std::count(faces.begin(), faces.end(), true));
  found.gap_mean = found.seen > 0.0 ? found.gap_mean / found.seen : 0.0;
  found.seen = std::min(found.seen, found.length); // round-off
  return found;
}

} // namespace

GapSurvey survey_gaps(const ContactSurface& from, const ContactSurface& to) {
  if (!from.space.faces.empty()) {
    const SurfaceProjection projection(from.space, to.space);
    return survey_space(from.space, [&](const SurfaceTriangle& triangle) {
      return projection.project_triangle(triangle);
    });
  }
  const std::vector<Edge>& targets = to.plane.edges;
  return sample(from, find_segments(from, to),
                [&](const MortarSegment& s, const Edge& edge, double xi) -> std::optional<Glance> {
                  const Edge& target = targets[s.target_edge];
                  const Vec2 n = surface_normal(from, edge, xi);
                  const Vec2 x = point_on(edge, xi);
                  const std::optional<double> eta = ray_intersection(target, x, n);
                  if (!eta) {
                    return std::nullopt;
                  }
                  const Vec2 back = surface_normal(to, target, std::clamp(*eta, -1.0, 1.0));
                  return Glance{(point_on(target, *eta) - x).dot(n), angle_between(n, -back)};
                });
}

GapSurvey survey_gaps(const ContactSurface& from, const model::RigidTarget& to) {
  if (!from.space.faces.empty()) {
    const AnalyticShape shape = rigid_target_shape(to);
    return survey_space(from.space, [&](const SurfaceTriangle& triangle) {
      return project_onto_rigid(from.space, shape, triangle);
    });
  }
  return sample(from, find_segments(from, to),
                [&](const MortarSegment&, const Edge& edge, double xi) -> std::optional<Glance> {
                  const std::optional<RigidProjection> foot =
                      normal_projection(to, point_on(edge, xi));
                  if (!foot) {
                    return std::nullopt;
                  }
                  const Vec2 n = surface_normal(from, edge, xi);
                  return Glance{foot->gap, angle_between(n, foot->normal)};
                });
}

} // namespace spricka::contact
