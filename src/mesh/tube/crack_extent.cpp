// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/crack_extent.hpp"

#include "geometry/polyline.hpp"
#include "mesh/tube/solid_front.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Dense>

namespace spricka::mesh {
namespace {

using base::Vec2;
using base::Vec3;

/// A stretch of a mouth on one face.
struct Chord {
  Vec3 from, to;
  SurfacePlace place; ///< in its middle
};

class CrackInBodyMeasurement {
public:
  CrackInBodyMeasurement(const SolidHostMesh& host, const SolidCrack& crack,
                         const LocatedSolidCrack& placed)
      : crack_(crack), placed_(placed), body_(host.body_surface(placed.seed)),
        surface_(body_.geometry()), area_(crack, placed.outlines) {}

  CrackExtentInBody measure() {
    find_chords();
    extent_.kind = classify_crack(placed_);
    extent_.seed = placed_.seed;
    extent_.area = area_.area();
    if (crack_.closed) {
      extent_.drawn = extent_.area / PlanePolygons(crack_, {crack_.front}).area();
    }
    name_faces();
    find_depth();
    follow_surface();
    return std::move(extent_);
  }

private:
  void find_chords() {
    placed_.for_each_mouth_segment([&](const Vec3& from, const Vec3& to) {
      if ((to - from).norm() > 0.0) {
        chords_.push_back({from, to, surface_.nearest_place(0.5 * (from + to))});
      }
    });
  }

  /// The smallest of the sets that have a face; empty: none has it.
  [[nodiscard]] std::string name_of_face(std::size_t face) {
    if (members_.empty()) {
      for (std::size_t f = 0; f < surface_.faces().size(); ++f) {
        for (const std::size_t set : surface_.face_sets(f)) {
          ++members_[set];
        }
      }
    }
    std::string name;
    std::size_t least = nowhere;
    for (const std::size_t set : surface_.face_sets(face)) {
      if (members_[set] < least && !body_.name_of_surface_face_set(set).empty()) {
        least = members_[set];
        name = body_.name_of_surface_face_set(set);
      }
    }
    return name;
  }

  /// Stretches of one name, or without one of one smooth piece, make one face.
  void name_faces() {
    std::vector<std::size_t> piece; // [open face]
    std::vector<double> nearest;    // [open face] of its stretches to the centre
    for (const Chord& chord : chords_) {
      const std::string name = name_of_face(chord.place.face);
      const std::size_t own = surface_.smooth_piece_index(chord.place.face);
      std::size_t k = 0;
      while (k < piece.size() &&
             (extent_.open[k].name != name || (name.empty() && piece[k] != own))) {
        ++k;
      }
      if (k == piece.size()) {
        piece.push_back(own);
        nearest.push_back(std::numeric_limits<double>::max());
        BodyFaceAtCrackMouth& fresh = extent_.open.emplace_back();
        fresh.name = name;
        fresh.at = chord.place.x;
        fresh.normal = chord.place.normal;
      }
      BodyFaceAtCrackMouth& open = extent_.open[k];
      open.length += (chord.to - chord.from).norm();
      const model::Face side = body_.face(chord.place.face);
      if (std::ranges::find(open.faces, side) == open.faces.end()) {
        open.faces.push_back(side);
      }
      if (crack_.middle) {
        measure_offset(chord, open, nearest[k]);
      }
    }
  }

  /// Of the line through the stretch that is nearest to the centre; positive: the centre lies on
  /// the body's side of it.
  void measure_offset(const Chord& chord, BodyFaceAtCrackMouth& open, double& nearest) const {
    const double away = geometry::distance_to_segment(*crack_.middle, chord.from, chord.to);
    if (away >= nearest) {
      return;
    }
    nearest = away;
    const Vec3 way = (chord.to - chord.from).normalized();
    const Vec3 foot = chord.from + (*crack_.middle - chord.from).dot(way) * way;
    const Vec3 off = foot - *crack_.middle;
    const double radius = radius_along(off);
    open.offset =
        radius > 0.0 ? std::copysign(off.norm() / radius, off.dot(chord.place.normal)) : 0.0;
  }

  /// Of the drawn ellipse from its middle; 0 along nothing.
  [[nodiscard]] double radius_along(const Vec3& way) const {
    const Vec2 q = area_.plane().project(area_.plane().origin + way);
    if (!(q.norm() > 0.0)) {
      return 0.0;
    }
    const Vec2 unit = q.normalized();
    const Vec2 middle = area_.plane().project(*crack_.middle);
    double radius = 0.0;
    double best = -1.0;
    for (const Vec3& x : crack_.front) {
      const Vec2 r = area_.plane().project(x) - middle;
      if (const double cosine = r.dot(unit) / r.norm(); cosine > best) {
        best = cosine;
        radius = r.norm();
      }
    }
    return radius;
  }

  void find_depth() {
    constexpr int samples = 64;
    const bool inside = extent_.kind == CrackConfiguration::embedded;
    extent_.depth = inside ? std::numeric_limits<double>::max() : 0.0;
    for (const InteriorFront& front : placed_.fronts) {
      for (int i = 0; i <= samples; ++i) {
        const Vec3 x = front.curve->at(static_cast<double>(i) / samples * front.curve->length()).x;
        if (inside) {
          const SurfacePlace near = surface_.nearest_place(x);
          if (const double away = (near.x - x).norm(); away < extent_.depth) {
            extent_.depth = away;
            extent_.nearest = name_of_face(near.face);
          }
        } else {
          double away = std::numeric_limits<double>::max();
          for (const Chord& chord : chords_) {
            away = std::min(away, geometry::distance_to_segment(x, chord.from, chord.to));
          }
          extent_.depth = std::max(extent_.depth, away);
        }
      }
    }
  }

  /// From the end of the one front on over the surface, away from the crack, to its beginning.
  void follow_surface() {
    if (placed_.fronts.size() != 1 || placed_.fronts.front().curve->closed()) {
      return;
    }
    const InteriorFront& front = placed_.fronts.front();
    const FrontCurve& curve = *front.curve;
    const TraceResult round =
        trace_crack_plane(surface_, crack_reference_plane(crack_), front.end[1], front.end[0],
                          curve.at(curve.length()).m);
    if (round.trouble) {
      return;
    }
    const SurfaceTrace& way = round.trace.front();
    constexpr int samples = 64;
    std::vector<Vec3> ligament;
    ligament.reserve(samples);
    for (int i = 0; i < samples; ++i) {
      ligament.push_back(curve.at(static_cast<double>(i) / samples * curve.length()).x);
    }
    for (std::size_t i = 0; i + 1 < way.points().size(); ++i) {
      const TracePoint& point = way.points()[i];
      ligament.push_back(point.place.x);
      if (extent_.kind != CrackConfiguration::surface || point.edge == nowhere ||
          surface_.edges()[point.edge].border) {
        continue;
      }
      if (std::isinf(extent_.to_edge[1])) {
        extent_.to_edge[1] = way.arc_lengths()[i];
        extent_.edge[1] = point.place.x;
      }
      extent_.to_edge[0] = way.length() - way.arc_lengths()[i];
      extent_.edge[0] = point.place.x;
    }
    extent_.of_section = extent_.area / (extent_.area + PlanePolygons(crack_, {ligament}).area());
  }

  const SolidCrack& crack_;
  const LocatedSolidCrack& placed_;
  const BodySurface& body_;
  const SurfaceGeometry& surface_;
  PlanePolygons area_;
  std::vector<Chord> chords_;
  std::map<std::size_t, std::size_t> members_; ///< of sets of the surface: their faces
  CrackExtentInBody extent_;
};

} // namespace

CrackConfiguration classify_crack(const LocatedSolidCrack& placed) {
  std::size_t mouths = placed.holes.size();
  std::size_t passed = 0;
  for (const InteriorFront& front : placed.fronts) {
    mouths += front.curve->closed() ? 0 : 1;
    passed += front.edges;
  }
  return mouths == 0                ? CrackConfiguration::embedded
         : mouths > 1 || passed > 1 ? CrackConfiguration::through
         : passed == 1              ? CrackConfiguration::corner
                                    : CrackConfiguration::surface;
}

std::optional<CrackExtentInBody> measure_crack_in_body(const SolidHostMesh& host,
                                                       const SolidCrack& crack) {
  LocatedSolidCrack request{&crack, nullptr, {}, {}};
  base::Diagnostics reported_by_the_cut;
  if (!locate_crack_in_host(host, request, reported_by_the_cut)) {
    return std::nullopt;
  }
  return CrackInBodyMeasurement(host, crack, request).measure();
}

} // namespace spricka::mesh
