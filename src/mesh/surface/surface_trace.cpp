// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/surface_trace.hpp"

#include "geometry/polyline.hpp"
#include "mesh/link/grading.hpp"
#include "mesh/plane.hpp"
#include "mesh/surface/surface_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace spricka::mesh {
namespace {

using base::Vec2;
using base::Vec3;

/// Moves r within the face until its point lies on the plane.
Vec2 onto_plane(const geometry::ElementSide& face, const CrackReferencePlane& plane, Vec2 r) {
  for (int i = 0; i < 8; ++i) {
    const geometry::SidePoint p = face.point(r);
    const Vec2 g = p.tangents.transpose() * plane.gradient_of_height_over_crack(p.x);
    const double height = plane.height_over_crack(p.x);
    if (!(g.squaredNorm() > 0.0) || std::abs(height) <= 1e-15 * plane.length) {
      break;
    }
    r = face.clamp_to_side(r - height / g.squaredNorm() * g);
  }
  return r;
}

/// The line in which facets of curved faces pass the plane: a stretch in each facet whose vertices
/// lie on both sides. A vertex on the plane counts as above, so that the line passes beside it.
class PlaneLine {
public:
  using Side = std::pair<int, int>; ///< of facets, lower vertex first
  struct Passing {
    std::size_t facet = nowhere;
    std::array<Side, 2> sides;
  };

  PlaneLine(const SurfaceGeometry& surface, const CrackReferencePlane& plane)
      : surface_(surface), plane_(plane),
        net_(surface, faces_near(surface, plane), finer(surface, plane)) {
    for (const Vec3& x : net_.vertices()) {
      height_.push_back(rounded(plane.height_over_crack(x) / plane.length));
    }
    for (std::size_t f = 0; f < net_.facets().size(); ++f) {
      add(f);
    }
  }

  [[nodiscard]] const std::vector<Passing>& passings() const { return passings_; }
  [[nodiscard]] const FacetTriangulation::SurfaceFacet& facet(std::size_t passing) const {
    return net_.facets()[passings_[passing].facet];
  }
  [[nodiscard]] Vec3 x(const Side& side) const { return at_.at(side).x; }

  /// The stretch nearest to a point. Those round a vertex on the plane have no length, and so no
  /// direction in which the line could be left or met: they are only passed.
  [[nodiscard]] std::size_t nearest(const Vec3& p) const {
    std::size_t best = nowhere;
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < passings_.size(); ++i) {
      const Vec3 a = x(passings_[i].sides[0]);
      const Vec3 b = x(passings_[i].sides[1]);
      if (!((b - a).norm() > coordinate_tolerance * plane_.length)) {
        continue;
      }
      const double away = rounded(geometry::distance_to_segment(p, a, b) / plane_.length);
      if (away < least) {
        least = away;
        best = i;
      }
    }
    return best;
  }
  /// The stretch beyond a side; `nowhere` if the surface ends or branches there.
  [[nodiscard]] std::size_t beyond(std::size_t passing, const Side& side) const {
    const std::vector<std::size_t>& both = beside_.at(side);
    return both.size() != 2 ? nowhere : both[0] == passing ? both[1] : both[0];
  }
  /// The passing point of a side in the reference coordinates of a facet.
  [[nodiscard]] Vec2 r(std::size_t passing, const Side& side) const {
    const FacetTriangulation::SurfaceFacet& facet = this->facet(passing);
    const double part = at_.at(side).part;
    return (1.0 - part) * r_of(facet, side.first) + part * r_of(facet, side.second);
  }
  [[nodiscard]] TracePoint point(std::size_t passing, const Side& side) const {
    TracePoint point;
    point.place = surface_.place_at_coordinates(facet(passing).face, r(passing, side));
    const FacetTriangulation::FacetEdgeSegment* on = net_.edge_segment(side.first, side.second);
    if (on != nullptr && surface_.edges()[on->edge].feature) {
      point.edge = on->edge;
      point.t = on->t[0] + at_.at(side).part * (on->t[1] - on->t[0]);
    }
    return point;
  }

private:
  struct PlaneCrossing {
    double part = 0.0; ///< from the lower vertex
    Vec3 x;
  };

  static std::vector<std::size_t> faces_near(const SurfaceGeometry& surface,
                                             const CrackReferencePlane& plane) {
    std::vector<std::size_t> faces;
    for (std::size_t f = 0; f < surface.faces().size(); ++f) {
      const geometry::Box<3> box = surface.face(f).bounding_box();
      const auto& [low, high] = box;
      const double middle = plane.signed_plane_distance(0.5 * (low + high));
      const double half = 0.5 * (high - low).dot(plane.normal.cwiseAbs());
      if (std::abs(middle) <= half + 1e-6 * plane.length ||
          (plane.relief && plane.relief->box().meets(box))) {
        faces.push_back(f);
      }
    }
    return faces;
  }

  /// Facets smaller than the strips of a crack that has turned: such a line may come back to the
  /// side where it has entered a larger one.
  static int finer(const SurfaceGeometry& surface, const CrackReferencePlane& plane) {
    constexpr double of_strip = 0.5;
    constexpr int most = 32;
    double longest = 0.0;
    for (std::size_t f = 0; f < surface.faces().size() && plane.relief; ++f) {
      const geometry::Box<3> box = surface.face(f).bounding_box();
      if (plane.relief->box().meets(box)) {
        const double own = surface.face(f).is_quadratic() ? FacetTriangulation::divisions : 1;
        longest = std::max(longest, box.diagonal() / own);
      }
    }
    if (!(longest > 0.0)) {
      return 1;
    }
    const double wanted = std::ceil(longest / (of_strip * plane.relief->narrowest_strip_width()));
    return static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(most)));
  }

  static Vec2 r_of(const FacetTriangulation::SurfaceFacet& facet, int vertex) {
    std::size_t c = 0;
    while (facet.vertex[c] != vertex) {
      ++c;
    }
    return facet.r[c];
  }

  [[nodiscard]] bool above(int vertex) const {
    return height_[static_cast<std::size_t>(vertex)] >= 0.0;
  }

  void add(std::size_t f) {
    const FacetTriangulation::SurfaceFacet& facet = net_.facets()[f];
    Passing passing{f, {}};
    std::size_t count = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const int v = facet.vertex[c];
      const int w = facet.vertex[(c + 1) % 3];
      if (above(v) != above(w)) {
        passing.sides[count++] = std::minmax(v, w);
      }
    }
    if (count == 0) {
      return;
    }
    for (const Side& side : passing.sides) {
      if (!at_.contains(side)) {
        const double part = root(facet, side);
        const Vec2 here = (1.0 - part) * r_of(facet, side.first) + part * r_of(facet, side.second);
        at_[side] = {part, surface_.face(facet.face).position(here)};
      }
      beside_[side].push_back(passings_.size());
    }
    passings_.push_back(passing);
  }

  /// Where between the two vertices the curved face passes the plane, by bisection and secants
  /// (Illinois); at a vertex that lies on the plane, there.
  [[nodiscard]] double root(const FacetTriangulation::SurfaceFacet& facet, const Side& side) const {
    for (const auto& [vertex, part] : {std::pair(side.first, 0.0), std::pair(side.second, 1.0)}) {
      if (height_[static_cast<std::size_t>(vertex)] == 0.0) {
        return part;
      }
    }
    const geometry::ElementSide& face = surface_.face(facet.face);
    const Vec2 r0 = r_of(facet, side.first);
    const Vec2 r1 = r_of(facet, side.second);
    const auto height = [&](double t) {
      return plane_.height_over_crack(face.position((1.0 - t) * r0 + t * r1));
    };
    double a = 0.0;
    double b = 1.0;
    double fa = height(a);
    double fb = height(b);
    double t = 0.5;
    for (int i = 0; i < 100 && b - a > 1e-16; ++i) {
      t = std::clamp((fa * b - fb * a) / (fa - fb), a, b);
      const double f = height(t);
      if (f == 0.0 || !(t > a && t < b)) {
        break;
      }
      if ((f > 0.0) == (fb > 0.0)) {
        b = t;
        fb = f;
        fa *= 0.5;
      } else {
        a = t;
        fa = f;
        fb *= 0.5;
      }
    }
    return t;
  }

  const SurfaceGeometry& surface_;
  const CrackReferencePlane& plane_;
  FacetTriangulation net_;
  std::vector<double> height_; ///< [vertex] rounded
  std::vector<Passing> passings_;
  std::map<Side, PlaneCrossing> at_;
  std::map<Side, std::vector<std::size_t>> beside_;
};

/// The way along a PlaneLine from one place to another.
class TraceWalk {
public:
  TraceWalk(const SurfaceGeometry& surface, const CrackReferencePlane& plane)
      : surface_(surface), plane_(plane), line_(surface, plane) {}

  TraceResult go(const SurfacePlace& from, const SurfacePlace& to, const Vec3& towards) {
    const std::size_t first = line_.nearest(from.x);
    const std::size_t last = line_.nearest(to.x);
    if (first == nowhere || !near(first, from.x) || !near(last, to.x)) {
      return {{}, {"the crack's mouth does not begin and end on the surface", from.x}};
    }
    points_.push_back({from, nowhere, 0.0});
    const auto& sides = line_.passings()[first].sides;
    const Vec3 along = line_.x(sides[1]) - line_.x(sides[0]);
    PlaneLine::Side side = sides[along.dot(towards) > 0.0 ? 1 : 0];
    std::size_t at = first;
    Vec2 r = surface_.face(line_.facet(at).face)
                 .nearest_local_coordinates(from.x, geometry::ClampedFootPolicy::replaced);
    // In its own stretch the end may lie behind the start; one that is entered is all ahead.
    bool ends = at == last && (to.x - from.x).dot(line_.x(side) - from.x) > 0.0;
    while (!ends) {
      add(at, r, line_.point(at, side), line_.r(at, side));
      const std::size_t next = line_.beyond(at, side);
      if (next == nowhere || visited_++ > line_.passings().size()) {
        return {{},
                {"the crack's plane leaves the surface without reaching the mouth's end",
                 points_.back().place.x}};
      }
      r = line_.r(next, side);
      const auto& both = line_.passings()[next].sides;
      side = both[0] == side ? both[1] : both[0];
      at = next;
      ends = at == last;
    }
    add(at, r, {to, nowhere, 0.0},
        surface_.face(line_.facet(at).face)
            .nearest_local_coordinates(to.x, geometry::ClampedFootPolicy::replaced));
    if (points_.size() < 2) {
      return {{}, {"the crack's mouth has no length", from.x}};
    }
    return {{SurfaceTrace(surface_, plane_, std::move(points_), std::move(segments_))}, {}};
  }

private:
  [[nodiscard]] bool near(std::size_t passing, const Vec3& x) const {
    const auto& sides = line_.passings()[passing].sides;
    const double reach = (line_.x(sides[1]) - line_.x(sides[0])).norm();
    const double away = std::min((line_.x(sides[0]) - x).norm(), (line_.x(sides[1]) - x).norm());
    return away <= 2.0 * reach + coordinate_tolerance * plane_.length;
  }

  /// A point of no length from the one before is not taken; its mark of an edge is.
  void add(std::size_t passing, const Vec2& r0, const TracePoint& point, const Vec2& r1) {
    TracePoint& before = points_.back();
    if ((point.place.x - before.place.x).norm() > coordinate_tolerance * plane_.length) {
      segments_.push_back({line_.facet(passing).face, r0, r1, 0.0});
      points_.push_back(point);
    } else if (point.edge != nowhere) {
      if (before.edge != nowhere && segments_.size() > 0 && before.edge != point.edge &&
          surface_.smooth_piece_index(segments_.back().face) ==
              surface_.smooth_piece_index(line_.facet(passing).face)) {
        return;
      }
      before.edge = point.edge;
      before.t = point.t;
    }
  }

  const SurfaceGeometry& surface_;
  const CrackReferencePlane& plane_;
  PlaneLine line_;
  std::vector<TracePoint> points_;
  std::vector<SurfaceTrace::TraceSegment> segments_;
  std::size_t visited_ = 0;
};

} // namespace

SurfaceTrace::SurfaceTrace(const SurfaceGeometry& surface, const CrackReferencePlane& plane,
                           std::vector<TracePoint> points, std::vector<TraceSegment> segments)
    : surface_(&surface), plane_(plane), points_(std::move(points)),
      segments_(std::move(segments)), arc_{0.0} {
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    segments_[i].s = arc_.back();
    arc_.push_back(arc_.back() + (points_[i + 1].place.x - points_[i].place.x).norm());
  }
}

SurfacePlace SurfaceTrace::at(double s) const {
  if (segments_.empty()) {
    return points_.front().place;
  }
  const auto [i, part] = geometry::position_at_length(arc_, s);
  const TraceSegment& segment = segments_[i];
  const Vec2 r = (1.0 - part) * segment.r0 + part * segment.r1;
  return surface_->place_at_coordinates(segment.face,
                                        onto_plane(surface_->face(segment.face), plane_, r));
}

TraceResult trace_crack_plane(const SurfaceGeometry& surface, const CrackReferencePlane& plane,
                              const SurfacePlace& from, const SurfacePlace& to,
                              const Vec3& towards) {
  return TraceWalk(surface, plane).go(from, to, towards);
}

namespace {

/// No corner at a bend nearer to another one than this part of the size of elements.
constexpr double least_of_size = 0.3;

} // namespace

std::vector<double> SurfaceTrace::kink_positions(double angle) const {
  constexpr int looks = 8; // between two points
  std::vector<double> all;
  if (!plane_.relief) {
    return all;
  }
  const NonPlanarCrackSurface& crack = *plane_.relief;
  const auto strip = [&](double s) { return crack.strip_number(at(s).x); };
  double before = 0.0;
  std::size_t last = strip(before);
  for (std::size_t i = 1; i < arc_.size(); ++i) {
    for (int k = 1; k <= looks; ++k) {
      const double here = arc_[i - 1] + (arc_[i] - arc_[i - 1]) * k / looks;
      const std::size_t now = strip(here);
      double low = before;
      double high = here;
      for (int step = 0; step < 40 && now != last; ++step) {
        const double middle = 0.5 * (low + high);
        (strip(middle) == last ? low : high) = middle;
      }
      if (now != last &&
          crack.distance_to_kink(at(high).x, angle) < crack.narrowest_strip_width() / looks) {
        all.push_back(high);
      }
      before = here;
      last = now;
    }
  }
  return all;
}

DividedTrace divide_trace_by_size(const SurfaceTrace& trace, const SizeFunction& size) {
  const auto size_of = [&](double at) { return size(trace.at(at).x); };
  DividedTrace line;
  double begin = 0.0;
  line.corners.push_back(trace.points().front());
  const auto go_to = [&](double end, const TracePoint& there) {
    const std::vector<double> s = divide_line_by_size(begin, end, size_of);
    for (std::size_t i = 0; i + 1 < s.size(); ++i) {
      line.mids.push_back(trace.at(0.5 * (s[i] + s[i + 1])));
      line.corners.push_back(i + 2 < s.size() ? TracePoint{trace.at(s[i + 1]), nowhere, 0.0}
                                              : there);
    }
    begin = end;
  };
  const std::vector<double> bends = trace.kink_positions(bent);
  std::size_t bend = 0;
  for (std::size_t i = 1; i < trace.points().size(); ++i) {
    if (trace.points()[i].edge == nowhere && i + 1 < trace.points().size()) {
      continue;
    }
    const double end = trace.arc_lengths()[i];
    for (; bend < bends.size() && bends[bend] < end; ++bend) {
      const double near = least_of_size * size_of(bends[bend]);
      if (bends[bend] > begin + near && bends[bend] < end - near) {
        go_to(bends[bend], {trace.at(bends[bend]), nowhere, 0.0});
      }
    }
    go_to(end, trace.points()[i]);
  }
  return line;
}

} // namespace spricka::mesh
