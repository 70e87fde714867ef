// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/surface_hits.hpp"

#include "mesh/surface/surface_geometry.hpp"

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
  const SurfacePlace place = surface.place_at_coordinates(guess.face, face.clamp_to_side(r));
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

bool is_inside_body(const SurfaceGeometry& surface, const Vec3& x) {
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

using base::Vec2;
using base::Vec3;

namespace {

constexpr int least_chords = 256; // their sagitta on a circle: 1e-4 of its radius

/// A place where the front passes the surface.
struct Crossing {
  double s = 0.0;
  SurfacePlace place;
  bool enters = false;
};

class FrontWalk {
public:
  FrontWalk(const SurfaceGeometry& surface, const FrontCurve& front)
      : surface_(surface), front_(front), reach_(front.closed() ? 0.0 : front_reach) {}

  InteriorFrontArcs arcs() {
    find_crossings();
    for (std::size_t i = 0; i < crossings_.size(); ++i) {
      const Crossing& next = crossings_[(i + 1) % crossings_.size()];
      const bool last = i + 1 == crossings_.size();
      if ((!last || front_.closed()) && crossings_[i].enters == next.enters) {
        return trouble("the front touches the surface, or runs along it", crossings_[i].place.x);
      }
    }
    return front_.closed() ? closed_arcs() : open_arcs();
  }

private:
  [[nodiscard]] Vec3 x(double s) const {
    const double L = front_.length();
    if (front_.closed() || (s >= 0.0 && s <= L)) {
      return front_.at(s).x;
    }
    const FrontFrame end = front_.at(s < 0.0 ? 0.0 : L);
    return end.x + (s < 0.0 ? s : s - L) * end.t;
  }

  static InteriorFrontArcs trouble(const std::string& why, const Vec3& at) {
    return {{}, {why, at}};
  }

  [[nodiscard]] std::optional<Crossing> refined(const CrossingGuess& guess, double s) const {
    constexpr int steps = 30;
    const auto curve = [&](double at) {
      const double inside = front_.closed() ? at : std::clamp(at, 0.0, front_.length());
      return CurveTangent{x(at), front_.at(inside).t};
    };
    const auto met = refine_crossing(surface_, guess, s, curve, steps);
    return met ? std::optional(
                     Crossing{met->s, met->place, met->place.normal.dot(met->tangent) < 0.0})
               : std::nullopt;
  }

  /// Chords that pass the facets of the surface, and those whose ends lie on both sides of the true
  /// surface: of a crack that is small against the facets it may be only these.
  void find_crossings() {
    const double L = front_.length();
    const double from = -reach_ * L;
    const double to = L + reach_ * L;
    const int chords = std::max(least_chords, 2 * static_cast<int>(front_.points().size()));
    const double ds = (to - from) / chords;
    SurfacePlace before = surface_.nearest_place(x(from));
    double height = (x(from) - before.x).dot(before.normal);
    for (int i = 0; i < chords; ++i) {
      const double s = from + i * ds;
      std::vector<CrossingGuess> guesses = guess_segment_crossings(surface_, x(s), x(s + ds));
      const SurfacePlace after = surface_.nearest_place(x(s + ds));
      const double next = (x(s + ds) - after.x).dot(after.normal);
      if ((height > 0.0) != (next > 0.0)) {
        guesses.push_back({before.face, before.r, height / (height - next)});
        guesses.push_back({after.face, after.r, height / (height - next)});
      }
      before = after;
      height = next;
      for (const CrossingGuess& guess : guesses) {
        const auto crossing = refined(guess, s + guess.part * ds);
        if (crossing && (front_.closed() || (crossing->s >= from && crossing->s <= to))) {
          add(*crossing);
        }
      }
    }
    std::ranges::sort(crossings_, {}, &Crossing::s);
  }

  /// Once at an edge, that of the lower face.
  void add(Crossing crossing) {
    const double L = front_.length();
    if (front_.closed()) {
      crossing.s -= L * std::floor(crossing.s / L);
    }
    for (Crossing& other : crossings_) {
      double apart = std::abs(other.s - crossing.s);
      apart = front_.closed() ? std::min(apart, L - apart) : apart;
      if (apart <= 1e-8 * L && other.enters == crossing.enters) {
        other = crossing.place.face < other.place.face ? crossing : other;
        return;
      }
    }
    crossings_.push_back(crossing);
  }

  InteriorFrontArcs closed_arcs() const {
    if (crossings_.empty()) {
      if (!is_inside_body(surface_, x(0.0))) {
        return trouble("the front lies outside of the body", x(0.0));
      }
      return {{InteriorFrontArc{{0.0, front_.length()}, {}, true}}, {}};
    }
    InteriorFrontArcs result;
    for (std::size_t i = 0; i < crossings_.size(); ++i) {
      if (crossings_[i].enters) {
        const Crossing& out = crossings_[(i + 1) % crossings_.size()];
        const double s1 = out.s + (out.s < crossings_[i].s ? front_.length() : 0.0);
        result.arcs.push_back({{crossings_[i].s, s1}, {crossings_[i].place, out.place}, false});
      }
    }
    return result;
  }

  InteriorFrontArcs open_arcs() const {
    const double L = front_.length();
    // What a straight prolongation meets beyond the surface does not matter.
    std::vector<InteriorFrontArc> arcs;
    for (std::size_t i = 0; i + 1 < crossings_.size(); ++i) {
      const InteriorFrontArc arc{{crossings_[i].s, crossings_[i + 1].s},
                                 {crossings_[i].place, crossings_[i + 1].place},
                                 false};
      if (crossings_[i].enters && arc.s[1] > 0.0 && arc.s[0] < L) {
        arcs.push_back(arc);
      }
    }
    for (const double end : {0.0, L}) {
      const bool covered = std::ranges::any_of(
          arcs, [&](const InteriorFrontArc& arc) { return arc.s[0] <= end && end <= arc.s[1]; });
      const bool near = std::ranges::any_of(
          crossings_, [&](const Crossing& c) { return std::abs(c.s - end) <= 1e-6 * L; });
      if (!covered && !near && is_inside_body(surface_, x(end))) {
        return trouble("the front ends in the body, away from its surface", x(end));
      }
    }
    if (arcs.empty()) {
      return trouble("the front lies outside of the body", x(0.0));
    }
    return {arcs, {}};
  }

  const SurfaceGeometry& surface_;
  const FrontCurve& front_;
  double reach_;
  std::vector<Crossing> crossings_;
};

} // namespace

InteriorFrontArcs find_interior_front_arcs(const SurfaceGeometry& surface,
                                           const FrontCurve& front) {
  return FrontWalk(surface, front).arcs();
}

} // namespace spricka::mesh
