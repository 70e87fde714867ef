// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/surface_hits.hpp"

#include "mesh/surface/facet_net.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace spricka::mesh {

using base::Vec2;
using base::Vec3;

namespace {

constexpr double facet_room = 0.1; // by how much of a facet a line may miss it in a guess
constexpr double box_room = 1e-6;  // of its box's diagonal, by which a line may miss a face
constexpr double on_face = 1e-9;   // outside of a face in reference coordinates

/// Where the line x + part d passes the plane of a facet.
std::optional<CrossingGuess> pass(const FacetTriangulation& net,
                                  const FacetTriangulation::SurfaceFacet& facet, const Vec3& x,
                                  const Vec3& d) {
  const std::array<Vec3, 3> p = net.corners(facet);
  const Vec3 u = p[1] - p[0];
  const Vec3 v = p[2] - p[0];
  const Vec3 n = u.cross(v);
  const double slope = n.dot(d);
  if (std::abs(slope) <= 1e-9 * n.norm() * d.norm()) {
    return std::nullopt; // along the facet: its neighbours are met
  }
  const double part = n.dot(p[0] - x) / slope;
  const Vec3 at = x + part * d - p[0];
  const double b = at.cross(v).dot(n) / n.squaredNorm();
  const double c = u.cross(at).dot(n) / n.squaredNorm();
  const double room = facet_room * std::max(u.norm(), v.norm()) / d.norm();
  if (std::min({b, c, 1.0 - b - c}) < -facet_room || part < -room || part > 1.0 + room) {
    return std::nullopt;
  }
  const Vec2 r = (1.0 - b - c) * facet.r[0] + b * facet.r[1] + c * facet.r[2];
  return CrossingGuess{facet.face, r, part};
}

} // namespace

std::optional<SurfaceCrossing> refine_crossing(const SurfaceGeometry& surface,
                                               const CrossingGuess& guess, double s,
                                               const std::function<CurveTangent(double)>& curve,
                                               int steps) {
  const geometry::ElementSide& face = surface.face(guess.face);
  Vec2 r = guess.r;
  Vec3 tangent = Vec3::Zero();
  for (int i = 0; i < steps; ++i) {
    const geometry::SidePoint p = face.point(r);
    const CurveTangent at = curve(s);
    tangent = at.tangent;
    Eigen::Matrix3d J;
    J << p.tangents, -tangent;
    const Vec3 step = J.inverse() * (at.x - p.x);
    if (!step.allFinite() || step.head<2>().norm() > 3.0) {
      return std::nullopt;
    }
    r += step.head<2>();
    s += step[2];
    if (step.head<2>().norm() < 1e-14) {
      break;
    }
  }
  if (!(face.distance_outside(r) <= on_face)) {
    return std::nullopt;
  }
  const SurfacePlace place = surface.place_at_coordinates(guess.face, face.clamp(r));
  const bool met = (place.x - curve(s).x).norm() <= 1e-8 * surface.diagonal();
  return met ? std::optional(SurfaceCrossing{s, place, tangent}) : std::nullopt;
}

std::vector<CrossingGuess> guess_segment_crossings(const SurfaceGeometry& surface, const Vec3& from,
                                                   const Vec3& to) {
  std::vector<CrossingGuess> guesses;
  const Vec3 d = to - from;
  for (const std::size_t f : surface.boxes().boxes_meeting_segment(from - facet_room * d,
                                                                   to + facet_room * d, box_room)) {
    const FacetTriangulation net(surface, std::array{f});
    for (const FacetTriangulation::SurfaceFacet& facet : net.facets()) {
      if (const auto guess = pass(net, facet, from, d)) {
        guesses.push_back(*guess);
      }
    }
  }
  return guesses;
}

std::vector<SurfaceHit> intersect_line_with_surface(const SurfaceGeometry& surface, const Vec3& x,
                                                    const Vec3& d, double most) {
  constexpr int steps = 20;
  const double same = 1e-9 * surface.diagonal();
  const auto line = [&](double along) { return CurveTangent{x + along * d, d}; };
  std::vector<SurfaceHit> all;
  for (const CrossingGuess& guess : guess_segment_crossings(surface, x, x + most * d)) {
    const auto hit = refine_crossing(surface, guess, guess.part * most, line, steps);
    if (hit && hit->s >= -same && hit->s <= most + same) {
      all.push_back({hit->place, hit->s});
    }
  }
  std::ranges::sort(all, [](const SurfaceHit& a, const SurfaceHit& b) {
    return a.along < b.along || (a.along == b.along && a.place.face < b.place.face);
  });
  std::vector<SurfaceHit> result;
  for (const SurfaceHit& hit : all) {
    const auto again = std::ranges::find_if(result, [&](const SurfaceHit& other) {
      return hit.along - other.along <= same && hit.leaves(d) == other.leaves(d);
    });
    if (again == result.end()) {
      result.push_back(hit);
    } else if (hit.place.face < again->place.face) {
      *again = hit;
    }
  }
  return result;
}

bool is_inside(const SurfaceGeometry& surface, const Vec3& x) {
  // Three lines in no special direction: one of them may run through an edge.
  static const std::array<Vec3, 3> directions{Vec3(0.5377, 0.7210, 0.4369).normalized(),
                                              Vec3(-0.3188, 0.4129, -0.8531).normalized(),
                                              Vec3(0.1763, -0.8622, 0.4749).normalized()};
  int votes = 0;
  for (const Vec3& d : directions) {
    votes += intersect_line_with_surface(surface, x, d, 2.0 * surface.diagonal()).size() % 2 == 1
                 ? 1
                 : 0;
  }
  return votes >= 2;
}

} // namespace spricka::mesh
