// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/survey.hpp"

#include "base/by_dimension.hpp"
#include "base/parallel.hpp"
#include "contact/rigid_target.hpp"
#include "contact/segment.hpp"
#include "contact/space/opposite.hpp"
#include "contact/space/rigid_round.hpp"
#include "contact/space/surface_projection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace spricka::contact {

namespace {

// Both ends without weight, then Gauss points of degree 5.
constexpr std::array<double, 5> sample_r{-1.0, 1.0, -0.7745966692414834, 0.0, 0.7745966692414834};
constexpr std::array<double, 5> sample_w{0.0, 0.0, 5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};

double angle_between(const Vec2& a, const Vec2& b) {
  return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
}

// A point of a surface that has something opposite.
struct SurveyedPoint {
  std::size_t facet = 0;
  double weight = 0.0; ///< length or area that it stands for
  double gap = 0.0;
  double angle = 0.0; ///< between one normal and the other reversed
};

GapSurvey summarize(const ContactSurface& from, double length,
                    const std::vector<SurveyedPoint>& points) {
  GapSurvey found;
  found.edges = from.facets.size();
  found.length = length;
  std::vector<bool> faces(found.edges, false);
  for (const SurveyedPoint& p : points) {
    const bool first = &p == &points.front();
    faces[p.facet] = true;
    found.seen += p.weight;
    found.gap_mean += p.weight * p.gap;
    found.gap_low = first ? p.gap : std::min(found.gap_low, p.gap);
    found.gap_high = first ? p.gap : std::max(found.gap_high, p.gap);
    found.angle_high = std::max(found.angle_high, p.angle);
  }
  found.facing = static_cast<std::size_t>(std::count(faces.begin(), faces.end(), true));
  found.gap_mean = found.seen > 0.0 ? found.gap_mean / found.seen : 0.0;
  found.seen = std::min(found.seen, found.length); // round-off
  return found;
}

// What a point xi of a segment sees; without its place and weight. None: nothing.
std::optional<SurveyedPoint> survey_point(const ContactSurface& from, const ContactSurface& to,
                                          const MortarSegment& s, double xi) {
  const Edge& edge = from.plane.edges[s.contact_edge];
  const Edge& target = to.plane.edges[s.target_edge];
  const Vec2 n = surface_normal(from, edge, xi);
  const Vec2 x = point_on_edge(edge, xi);
  const std::optional<double> eta = ray_intersection(target, x, n);
  if (!eta) {
    return std::nullopt;
  }
  const Vec2 back = surface_normal(to, target, std::clamp(*eta, -1.0, 1.0));
  return SurveyedPoint{.gap = (point_on_edge(target, *eta) - x).dot(n),
                       .angle = angle_between(n, -back)};
}

std::optional<SurveyedPoint> survey_point(const ContactSurface& from, const model::RigidTarget& to,
                                          const MortarSegment& s, double xi) {
  const Edge& edge = from.plane.edges[s.contact_edge];
  const std::optional<RigidProjection> foot = normal_projection(to, point_on_edge(edge, xi));
  if (!foot) {
    return std::nullopt;
  }
  const Vec2 n = surface_normal(from, edge, xi);
  return SurveyedPoint{.gap = foot->gap, .angle = angle_between(n, foot->normal)};
}

ElementProjector triangle_projector(const ContactSurface& from, const ContactSurface& to) {
  return [projection = std::make_shared<SurfaceProjector>(from, to)](const HatElement& triangle) {
    return projection->project_triangle(triangle);
  };
}

ElementProjector triangle_projector(const ContactSurface& from, const model::RigidTarget& to) {
  return [&from, shape = rigid_target_shape(to).value()](const HatElement& triangle) {
    return project_triangle_onto_rigid(from, shape, triangle);
  };
}

template <class Target> GapSurvey survey_edges(const ContactSurface& from, const Target& to) {
  double length = 0.0;
  for (const Edge& edge : from.plane.edges) {
    length += edge.length;
  }
  std::vector<SurveyedPoint> points;
  std::vector<FacingFacetPart> parts;
  for (const MortarSegment& s : find_mortar_segments(from, to)) {
    const Edge& edge = from.plane.edges[s.contact_edge];
    // Coordinates of an edge run from -1 to 1: half the stretch is its part of the edge.
    parts.push_back(
        {.facet = s.contact_edge,
         .measure = 0.5 * (s.to - s.from) * facet_length_or_area(from.facets[s.contact_edge])});
    for (std::size_t i = 0; i < sample_r.size(); ++i) {
      const double xi = 0.5 * ((s.to + s.from) + (s.to - s.from) * sample_r[i]);
      if (std::optional<SurveyedPoint> point = survey_point(from, to, s, xi)) {
        point->facet = s.contact_edge;
        point->weight = 0.5 * (s.to - s.from) * sample_w[i] * edge_tangent(edge, xi).norm();
        points.push_back(*point);
        parts.back().gap = sample_r[i] == 0.0 ? point->gap : parts.back().gap;
      }
    }
  }
  GapSurvey found = summarize(from, length, points);
  found.parts = std::move(parts);
  return found;
}

template <class Target> GapSurvey survey_faces(const ContactSurface& from, const Target& to) {
  const ElementProjector project = triangle_projector(from, to);
  double area = 0.0;
  std::vector<SurveyedPoint> points;
  base::make_and_take_in_order(
      from.elements.size(), elements_at_a_time,
      [&](std::size_t e) { return project(from.elements[e]); },
      [&](std::size_t /*e*/, const OppositePointsOfElement& projection) {
        area += projection.whole.sum();
        for (const PairPoint& p : projection.points) {
          points.push_back({p.facet, p.weight, p.gap, std::acos(std::min(1.0, p.turn))});
        }
      });
  GapSurvey found = summarize(from, area, points);
  for (const SurveyedPoint& p : points) {
    found.parts.push_back({p.facet, p.weight, p.gap});
  }
  return found;
}

template <class Target>
constexpr base::ByDimension surveys{survey_edges<Target>, survey_faces<Target>};

} // namespace

GapSurvey survey_gaps(const ContactSurface& from, const ContactSurface& to) {
  return surveys<ContactSurface>.at(from.dim)(from, to);
}

GapSurvey survey_gaps(const ContactSurface& from, const model::RigidTarget& to) {
  return surveys<model::RigidTarget>.at(from.dim)(from, to);
}

} // namespace spricka::contact
