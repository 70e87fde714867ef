// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/tube_room.hpp"

#include "geometry/box.hpp"
#include "geometry/polyline.hpp"
#include "mesh/plane.hpp"
#include "mesh/surface/surface_hits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace spricka::mesh {

using base::Vec2;
using base::Vec3;

void CrackDistanceField::add_tube(const Tube& tube) {
  const std::size_t n = tube.stations.size();
  free_ = free_ || tube.free;
  for (std::size_t i = 0; i < (tube.closed ? n : n - 1); ++i) {
    const std::size_t next = (i + 1) % n;
    pieces_.push_back({tube.stations[i].x, tube.stations[next].x,
                       std::max(tube.radius[i], tube.radius[next]),
                       std::max(tube.fill_size_beside_tube(i), tube.fill_size_beside_tube(next))});
  }
  geometry::Box<3> box;
  double most = 0.0;
  for (const std::vector<Vec2>& outline : area_.outlines()) {
    for (const Vec2& q : outline) {
      const Vec3 x = plane().lift_to_crack(q);
      box.extend({x, x});
    }
  }
  for (const FrontSegment& piece : pieces_) {
    box.extend({piece.from, piece.from});
    most = std::max(most, piece.radius);
  }
  middle_ = 0.5 * (box.low + box.high);
  radius_ = 0.5 * box.diagonal() + most;
}

CrackDistanceField::DistancesFromCrack CrackDistanceField::distance(const Vec3& p) const {
  DistancesFromCrack result;
  double least = std::numeric_limits<double>::max();
  for (const FrontSegment& piece : pieces_) {
    const Vec3 along = piece.to - piece.from;
    const double part = geometry::nearest_segment_parameter(p, piece.from, piece.to);
    const double d = (piece.from + part * along - p).squaredNorm();
    if (d < least) {
      least = d;
      result.radius = piece.radius;
      result.size = piece.size;
    }
  }
  result.front = std::sqrt(least);
  result.surface = area_.distance(p);
  return result;
}

namespace {

constexpr int steps = 128;
constexpr int directions = 16;
/// What lies nearer to a front's end along the front than some times its distance across it is the
/// surface that the front ends on: as many times as that surface leans, and a half more; no less
/// than this.
constexpr double least_lean = 1.7;
/// A surface is another one if the front's end lies so far beside its tangent plane, as a part of
/// the way to it.
constexpr double other_surface = 0.7;
/// Near its ends a crack is as wide as a little inside.
constexpr double end_part = 0.05;

} // namespace

TubeClearance::TubeClearance(const SolidHostMesh& host, const LocatedSolidCrack& request,
                             const InteriorFront& front, std::span<const LocatedSolidCrack> all)
    : host_(host), request_(request), front_(front), area_(*request.crack, request.outlines) {
  for (const LocatedSolidCrack& other : all) {
    if (other.crack != request.crack) {
      others_.emplace_back(*other.crack, other.outlines);
    }
  }
  for (int i = 0; i <= steps; ++i) {
    free_.push_back(free_at(front_.curve->at(front_.curve->length() * i / steps)));
  }
}

double TubeClearance::clearance(double s) const {
  const double place = std::clamp(s / front_.curve->length(), 0.0, 1.0) * steps;
  const auto i = std::min(static_cast<std::size_t>(place), free_.size() - 2);
  return std::min(free_[i], free_[i + 1]);
}

double TubeClearance::free_at(const FrontFrame& at) const {
  const std::size_t part = host_.property_part_index(request_.seed);
  double least =
      front_.curve->closed()
          ? host_.skin_tree(part).nearest(at.x).distance
          : std::min(host_.interface_tree(part).nearest(at.x).distance, across_section(at));
  for (const PlanePolygons& other : others_) {
    least = std::min(least, other.distance(at.x));
  }
  return least;
}

double TubeClearance::end_inclination(std::size_t end) const {
  const double cosine = std::abs(
      front_.end[end].normal.dot(front_.curve->at(end == 0 ? 0.0 : front_.curve->length()).t));
  return std::sqrt(std::max(0.0, 1.0 - cosine * cosine)) / std::max(cosine, 1e-9);
}

double TubeClearance::across_section(const FrontFrame& at) const {
  const SurfaceGeometry& surface = host_.body_surface(request_.seed).geometry();
  const bool first = at.s < 0.5 * front_.curve->length();
  const double to_end = first ? at.s : front_.curve->length() - at.s;
  const double beside_end = std::max(least_lean, 1.5 * end_inclination(first ? 0 : 1) + 0.5);
  double least = surface.diagonal();
  for (int k = 0; k < directions; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / directions;
    const Vec3 d = std::cos(angle) * at.m + std::sin(angle) * at.b;
    for (const SurfaceHit& hit : intersect_line_with_surface(surface, at.x, d, least)) {
      // What the front's end lies far beside of is another surface, however near the end is.
      const bool other = !front_.curve->closed() &&
                         hit.along > coordinate_tolerance * surface.diagonal() &&
                         std::abs(hit.place.normal.dot(front_.end[first ? 0 : 1].x - hit.place.x)) >
                             other_surface * hit.along;
      // At the end itself lines along the surface pass it at once, a little before or behind.
      if (other || to_end > beside_end * std::max(hit.along, 0.0) + coordinate_tolerance * least) {
        least = std::min(least, hit.along);
      }
    }
  }
  return least;
}

double TubeClearance::crack_width(double s) const {
  const FrontCurve& curve = *front_.curve;
  const double inside =
      curve.closed() ? s
                     : std::clamp(s, end_part * curve.length(), (1.0 - end_part) * curve.length());
  const FrontFrame at = curve.at(inside);
  const PlaneBasis& plane = area_.plane();
  const Vec2 q = plane.project(at.x);
  const Vec2 back = plane.project(at.x - at.m) - q;
  const auto along = area_.exit_multiple_of_direction(q, back);
  if (!along) {
    return std::numeric_limits<double>::max();
  }
  const Vec2 end = q + *along * back;
  bool at_mouth = false;
  request_.for_each_mouth_segment([&](const Vec3& from, const Vec3& to) {
    const double away = geometry::distance_to_segment(end, plane.project(from), plane.project(to));
    at_mouth = at_mouth || away < coordinate_tolerance * *along;
  });
  return at_mouth ? 2.0 * *along : *along;
}

double TubeClearance::kink_distance(double s) const {
  const NonPlanarCrackSurface* relief = request_.crack->relief.get();
  return relief != nullptr ? relief->distance_to_kink(front_.curve->at(s).x, bent)
                           : std::numeric_limits<double>::max();
}

} // namespace spricka::mesh
