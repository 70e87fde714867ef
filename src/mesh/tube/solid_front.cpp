// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/solid_front.hpp"

#include "mesh/surface/surface_hits.hpp"
#include "mesh/tube/solid_crack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace spricka::mesh {
namespace {

using base::ElementId;
using base::Vec3;

constexpr int front_samples = 64;

/// Lengths between the two of a range at which a polygon along a curve has its corners: as far
/// apart as given, and nowhere turning by more than a little.
std::vector<double> steps_along(const FrontCurve& curve, const std::array<double, 2>& range,
                                double apart) {
  constexpr double most_turn = 0.1; // [rad]: its chords lie an eightieth of their length off
  const double least = 0.01 * apart;
  std::vector<double> steps;
  double s = range[0];
  while (true) {
    double step = apart;
    for (int i = 0; i < 4; ++i) { // the bend half way and at the end counts too
      for (const double at : {s, s + 0.5 * step, s + step}) {
        const double bend = std::abs(curve.at(at).curvature());
        step = bend * step > most_turn ? std::max(least, most_turn / bend) : step;
      }
    }
    s += step;
    if (s >= range[1] - 0.5 * step) {
      return steps;
    }
    steps.push_back(s);
  }
}

/// A place where the front runs along a plane face of the body, as of a crack whose normal is
/// that of the face.
std::optional<Vec3> place_along_face(const SurfaceGeometry& surface, const SolidCrack& crack,
                                     const FrontCurve& whole) {
  constexpr double on_it = 1e-6; // of the front
  constexpr double same_normal = 1.0 - 1e-6;
  constexpr int much = front_samples / 10;
  int along = 0;
  std::optional<Vec3> first;
  for (int i = 0; i < front_samples && !crack.relief; ++i) {
    const Vec3 x = whole.at((i + 0.5) / front_samples * whole.length()).x;
    const SurfacePlace near = surface.nearest_place(x);
    if ((near.x - x).norm() < on_it * whole.length() &&
        std::abs(near.normal.dot(crack.normal)) > same_normal) {
      first = first ? first : std::optional(x);
      ++along;
    }
  }
  return along > much ? first : std::nullopt;
}

/// The curve of an arc on its own, through the same points.
InteriorFront front_of(const InteriorFrontArc& arc, const SolidCrack& crack,
                       const FrontCurve& whole) {
  if (arc.whole) {
    return {std::make_shared<const FrontCurve>(whole), arc.place};
  }
  // As dense as the curve's own points, or as it bends, but not at the ends.
  const double length = arc.s[1] - arc.s[0];
  const double spacing = whole.length() / static_cast<double>(whole.points().size());
  std::vector<Vec3> points{arc.place[0].x};
  for (const double s : steps_along(whole, arc.s, std::min(spacing, length / 4.0))) {
    points.push_back(whole.at(s).x);
  }
  points.push_back(arc.place[1].x);
  std::vector<Vec3> normals = crack.normals_at(points);
  return {std::make_shared<const FrontCurve>(std::move(points), std::move(normals), false),
          arc.place};
}

/// The hole whose surface passes near a point of the crack's plane, if all of it lies within.
std::optional<BodyHoleInCrack> find_hole(const SurfaceGeometry& surface,
                                         const CrackReferencePlane& plane,
                                         const PlanePolygons& area, const Vec3& at) {
  SurfacePlace near = surface.nearest_place(at);
  const Vec3 towards = near.normal.cross(plane.normal);
  const TraceResult first = trace_crack_plane(surface, plane, near, near, towards);
  if (first.trouble) {
    return std::nullopt;
  }
  // Begun anew half way between two of its points, which lies on the plane and on no edge.
  BodyHoleInCrack hole{first.trace.front().at(0.5 * first.trace.front().arc_lengths()[1]), {}, {}};
  hole.towards = hole.from.normal.cross(plane.normal);
  const TraceResult all = trace_crack_plane(surface, plane, hole.from, hole.from, hole.towards);
  if (all.trouble) {
    return std::nullopt;
  }
  for (const TracePoint& point : all.trace.front().points()) {
    hole.mouth.push_back(point.place.x);
  }
  hole.mouth.pop_back();
  const bool within = std::ranges::all_of(
      hole.mouth, [&](const Vec3& x) { return area.contains(area.plane().project(x)); });
  return within && hole.mouth.size() >= 3 ? std::optional(std::move(hole)) : std::nullopt;
}

class Placer {
public:
  Placer(const SolidHostMesh& host, LocatedSolidCrack& request, base::Diagnostics& diagnostics)
      : host_(host), request_(request), crack_(*request.crack), diagnostics_(diagnostics),
        whole_(crack_.front, crack_.normals_at(crack_.front), crack_.closed) {}

  bool place() {
    if (!find_seed()) {
      return fail("no part of its front lies in the body", crack_.front.front());
    }
    const SurfaceGeometry& surface = host_.body_surface(request_.seed).geometry();
    if (const std::optional<Vec3> other = place_in_other_body(surface)) {
      return fail(
          fmt::format("its front begins in the body round {} and lies in another one of its net",
                      coordinate_text(host_.bounding_ball(request_.seed).middle)),
          *other,
          "give each body a net of its own ($IMPORT ESET= takes one of an .inp) and name the "
          "cracked one with NET=");
    }
    if (const std::optional<Vec3> at = place_along_face(surface, crack_, whole_)) {
      return fail("its plane lies in a face of the body", *at,
                  "NORMAL, or the way from X0 to X1, is the normal of the crack's plane: a crack "
                  "that opens at a face stands across it; for a crack in a plane of symmetry model "
                  "the body on both sides of that plane");
    }
    const InteriorFrontArcs arcs = find_interior_front_arcs(surface, whole_);
    if (arcs.trouble) {
      return fail(arcs.trouble.why, arcs.trouble.at);
    }
    for (const InteriorFrontArc& arc : arcs.arcs) {
      request_.fronts.push_back(front_of(arc, crack_, whole_));
    }
    for (InteriorFront& front : request_.fronts) {
      if (!front.curve->closed() && !find_crack_mouth(surface, front)) {
        return false;
      }
    }
    if (!find_outlines()) {
      return false;
    }
    if (crack_.middle && !leave_out_areas_apart()) {
      return fail("no part of its front lies in the body where its middle is", *crack_.middle);
    }
    return stays_in_part() && nothing_crosses();
  }

private:
  bool fail(const std::string& why, const Vec3& at, const std::string& hint = {}) {
    diagnostics_.error(
        request_.span, "E425",
        fmt::format("{}: {}, at {}", crack_.display_name(), why, coordinate_text(at)), hint);
    return false;
  }

  /// More places where little of the front lies in the body, as of a long ellipse through a plate.
  bool find_seed() {
    for (int count = front_samples; count <= 100 * front_samples && !request_.seed.valid();
         count *= 10) {
      for (int i = 0; i < count && !request_.seed.valid(); ++i) {
        const double s = (i + 0.5) / count * whole_.length();
        request_.seed = host_.find_element_at(whole_.at(s).x, crack_.net).value_or(ElementId());
      }
    }
    return request_.seed.valid();
  }

  /// A place of the whole front in another body than the one that it begins in: which of the two is
  /// cracked would be left to chance.
  [[nodiscard]] std::optional<Vec3> place_in_other_body(const SurfaceGeometry& surface) const {
    constexpr double at_surface = 1e-3; // of the front: where bodies touch their meshes may overlap
    for (int i = 0; i < front_samples; ++i) {
      const Vec3 x = whole_.at((i + 0.5) / front_samples * whole_.length()).x;
      const auto e = host_.find_element_at(x, crack_.net);
      if (e && &host_.body_surface(*e) != &host_.body_surface(request_.seed) &&
          (surface.nearest_place(x).x - x).norm() > at_surface * whole_.length()) {
        return x;
      }
    }
    return std::nullopt;
  }

  bool find_crack_mouth(const SurfaceGeometry& surface, InteriorFront& front) {
    const FrontFrame end = front.curve->at(front.curve->length());
    double least = std::numeric_limits<double>::max();
    SurfaceFailure trouble;
    for (std::size_t k = 0; k < request_.fronts.size(); ++k) {
      const TraceResult traced = trace_crack_plane(surface, crack_reference_plane(crack_),
                                                   front.end[1], request_.fronts[k].end[0], -end.m);
      trouble = traced.trouble ? traced.trouble : trouble;
      // The first front that it comes to.
      if (!traced.trouble && traced.trace.front().length() < least) {
        least = traced.trace.front().length();
        front.next = k;
        front.mouth.clear();
        front.edges = 0;
        for (const TracePoint& point : traced.trace.front().points()) {
          front.mouth.push_back(point.place.x);
          const bool edge = point.edge != nowhere && !surface.edges()[point.edge].border;
          front.edges += edge ? 1 : 0;
        }
      }
    }
    return !front.mouth.empty() || fail("it has no mouth: " + trouble.why, trouble.at);
  }

  bool find_outlines() {
    std::vector<bool> done(request_.fronts.size(), false);
    area_.resize(request_.fronts.size());
    for (std::size_t first = 0; first < done.size(); ++first) {
      if (done[first]) {
        continue;
      }
      std::vector<Vec3>& outline = request_.outlines.emplace_back();
      std::size_t k = first;
      for (; !done[k]; k = request_.fronts[k].next) {
        done[k] = true;
        area_[k] = request_.outlines.size() - 1;
        const InteriorFront& front = request_.fronts[k];
        const FrontCurve& curve = *front.curve;
        outline.push_back(curve.at(0.0).x);
        const double spacing = curve.length() / static_cast<double>(curve.points().size());
        for (const double s : steps_along(curve, {0.0, curve.length()}, spacing)) {
          outline.push_back(curve.at(s).x);
        }
        if (!curve.closed()) {
          outline.push_back(curve.at(curve.length()).x);
        }
        if (front.curve->closed()) {
          k = first;
          break;
        }
        outline.insert(outline.end(), front.mouth.begin() + 1, front.mouth.end() - 1);
      }
      if (k != first) {
        return fail("its mouths do not lead from front to front", outline.front());
      }
    }
    return true;
  }

  /// An ellipse about a place on the wall of a hole reaches the body behind the hole, too, once it
  /// is wide enough: that is no part of the crack. An ellipse about a place in the hole has both.
  /// False: what is left is none of it, as where the body ends before the ellipse.
  bool leave_out_areas_apart() {
    constexpr double at_it = 0.05; // of the shorter axis: coarse facets lie off a round wall
    const Vec3& middle = *crack_.middle;
    double axis = std::numeric_limits<double>::max();
    for (const Vec3& x : crack_.front) {
      axis = std::min(axis, (x - middle).norm());
    }
    const double near = at_it * axis;
    std::vector<bool> kept;
    for (const std::vector<Vec3>& outline : request_.outlines) {
      kept.push_back(PlanePolygons(crack_, {outline}).distance(middle) < near);
    }
    if (std::ranges::find(kept, true) == kept.end()) {
      const SurfaceGeometry& surface = host_.body_surface(request_.seed).geometry();
      return !host_.find_element_at(middle, crack_.net) &&
             (surface.nearest_place(middle).x - middle).norm() > near;
    }
    if (std::ranges::find(kept, false) == kept.end()) {
      return true;
    }
    std::vector<InteriorFront> fronts;
    std::vector<std::size_t> place(request_.fronts.size());
    for (std::size_t k = 0; k < request_.fronts.size(); ++k) {
      InteriorFront& front = request_.fronts[k];
      const Vec3 halfway = front.curve->at(0.5 * front.curve->length()).x;
      if (!kept[area_[k]]) {
        request_.left_out = halfway;
        continue;
      }
      request_.seed = host_.find_element_at(halfway, crack_.net).value_or(request_.seed);
      place[k] = fronts.size();
      fronts.push_back(std::move(front));
    }
    for (InteriorFront& front : fronts) {
      front.next = place[front.next];
    }
    std::vector<std::vector<Vec3>> outlines;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      if (kept[i]) {
        outlines.push_back(std::move(request_.outlines[i]));
      }
    }
    request_.fronts = std::move(fronts);
    request_.outlines = std::move(outlines);
    return true;
  }

  bool stays_in_part() {
    for (const InteriorFront& front : request_.fronts) {
      for (int i = 0; i < front_samples; ++i) {
        const Vec3 x = front.curve->at((i + 0.5) / front_samples * front.curve->length()).x;
        const auto e = host_.find_element_at(x, crack_.net);
        if (e && host_.property_part_index(*e) != host_.property_part_index(request_.seed)) {
          diagnostics_.error(
              request_.span, "E424",
              fmt::format("{}: its front goes from elements of one $PROPERTY to those "
                          "of another at {}",
                          crack_.display_name(), coordinate_text(x)),
              "a crack lies in elements of one $PROPERTY: where material and state "
              "are the same give them one; move the crack off the border of two "
              "materials");
          return false;
        }
      }
    }
    return true;
  }

  /// Where the surface of the body, or another material, crosses the crack.
  [[nodiscard]] std::optional<Vec3> crossing(const PlanePolygons& area) const {
    const std::size_t part = host_.property_part_index(request_.seed);
    const SurfaceGeometry& surface = host_.body_surface(request_.seed).geometry();
    const double rim = 1e-2 * make_crack_frame(crack_).a; // a mouth lies on the surface
    const auto in_area = [&](const Vec3& x) {
      return area.is_well_within(area.plane().project(x), rim);
    };
    // Flat triangles lie inside of a round surface, by more than the rim of a small crack.
    const auto truly_in_area = [&](const Vec3& x) {
      return in_area(x) && in_area(surface.nearest_place(x).x);
    };
    std::optional<Vec3> found;
    const auto look = [&](const geometry::TriangleTree& tree, const auto& counts) {
      for (const geometry::CornerPlaces& triangle : tree.triangles()) {
        if (found) {
          return;
        }
        const std::vector<Vec3> places = area.intersect_plane_with_triangle(triangle);
        const auto at = std::ranges::find_if(places, counts);
        found = at != places.end() ? std::optional(*at) : std::nullopt;
      }
    };
    look(host_.interface_tree(part), in_area);
    look(host_.skin_tree(part), truly_in_area);
    return found;
  }

  /// Holes of the body within the crack are mouths; nothing else of the surface, and no other
  /// material, lies there.
  bool nothing_crosses() {
    constexpr std::size_t most_holes = 100;
    while (true) {
      const PlanePolygons area(crack_, request_.outlines);
      const std::optional<Vec3> at = crossing(area);
      if (!at) {
        return true;
      }
      std::optional<BodyHoleInCrack> hole =
          request_.holes.size() == most_holes
              ? std::nullopt
              : find_hole(host_.body_surface(request_.seed).geometry(),
                          crack_reference_plane(crack_), area, *at);
      if (!hole) {
        return fail("the surface of the body, or the border to another $PROPERTY, crosses it", *at);
      }
      request_.outlines.push_back(hole->mouth);
      request_.holes.push_back(std::move(*hole));
    }
  }

  const SolidHostMesh& host_;
  LocatedSolidCrack& request_;
  const SolidCrack& crack_;
  base::Diagnostics& diagnostics_;
  FrontCurve whole_;
  std::vector<std::size_t> area_; ///< [front] that it borders: into the request's outlines
};

} // namespace

std::string coordinate_text(const Vec3& x) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", x.x(), x.y(), x.z());
}

CrackReferencePlane crack_reference_plane(const SolidCrack& crack) {
  const CrackFrame frame = make_crack_frame(crack);
  return {frame.origin, crack.normal, frame.a, frame.axes.col(0), crack.relief};
}

bool locate_crack_in_host(const SolidHostMesh& host, LocatedSolidCrack& request,
                          base::Diagnostics& diagnostics) {
  return Placer(host, request, diagnostics).place();
}

} // namespace spricka::mesh
