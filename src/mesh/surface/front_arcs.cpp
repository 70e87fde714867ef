// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/front_arcs.hpp"

#include "mesh/surface/surface_hits.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace spricka::mesh {

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
      if (!is_inside(surface_, x(0.0))) {
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
      if (!covered && !near && is_inside(surface_, x(end))) {
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
