// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/front_curve.hpp"
#include "mesh/surface/surface_geometry.hpp"
#include "mesh/surface/surface_trace.hpp"

#include <array>
#include <functional>
#include <optional>
#include <vector>

/// Where lines and fronts of cracks pass the surface of a body.
namespace spricka::mesh {

/// Where the line from x along the unit vector d meets the surface: at x + along d.
struct SurfaceHit {
  SurfacePlace place;
  double along = 0.0;
  /// Whether a line along d goes out of the body here.
  [[nodiscard]] bool leaves(const base::Vec3& d) const { return place.normal.dot(d) > 0.0; }
};

/// All of them up to x + most d, nearest first, on the true faces; an edge or a corner that the
/// line passes through counts once. Empty: it meets nothing.
std::vector<SurfaceHit> intersect_line_with_surface(const SurfaceGeometry& surface,
                                                    const base::Vec3& x, const base::Vec3& d,
                                                    double most);

/// Whether x lies in the body (on the surface: either), by what lines from it pass.
bool is_inside_body(const SurfaceGeometry& surface, const base::Vec3& x);

/// Where a segment passes the facets of curved faces, or misses them by a little: first guesses of
/// where a line passes the faces themselves.
struct CrossingGuess {
  std::size_t face = nowhere;
  base::Vec2 r = base::Vec2::Zero();
  double part = 0.0; ///< of the segment
};
/// A point of a curve with its tangent, the derivative by the parameter.
struct CurveTangent {
  base::Vec3 x = base::Vec3::Zero();
  base::Vec3 tangent = base::Vec3::Zero();
};
/// Where a curve passes a face.
struct SurfaceCrossing {
  double s = 0.0; ///< parameter of the curve
  SurfacePlace place;
  base::Vec3 tangent = base::Vec3::Zero(); ///< of the curve
};
/// Where a curve passes the face of a guess, from its parameter s there on by at most `steps` of
/// Newton's method; empty where it does not.
std::optional<SurfaceCrossing> refine_crossing(const SurfaceGeometry& surface,
                                               const CrossingGuess& guess, double s,
                                               const std::function<CurveTangent(double)>& curve,
                                               int steps);
/// First guesses of where the segment from `from` to `to` passes the faces; those that it only
/// comes near to are among them.
std::vector<CrossingGuess> guess_segment_crossings(const SurfaceGeometry& surface,
                                                   const base::Vec3& from, const base::Vec3& to);

/// A part of a front that lies in the body: from length s[0] to s[1] > s[0] of the curve, with the
/// places of the surface there. Of a closed curve s[1] may exceed its length (FrontCurve::at counts
/// on). An open curve may go on straight a little to reach the surface: s[0] < 0, s[1] > length.
struct InteriorFrontArc {
  std::array<double, 2> s{0.0, 0.0};
  std::array<SurfacePlace, 2> place;
  bool whole = false; ///< a closed curve inside of the body: no places, s = 0 and its length
};

struct InteriorFrontArcs {
  std::vector<InteriorFrontArc> arcs; ///< ascending by s[0]
  SurfaceFailure trouble; ///< if an open front ends in the body, or none of it is inside
};

/// How far an open front may end below the surface and still be prolonged to it, in parts of its
/// length: a bore of coarse facets lies off the true one.
inline constexpr double front_reach = 0.1;

/// Which parts of a front the body has.
InteriorFrontArcs find_interior_front_arcs(const SurfaceGeometry& surface, const FrontCurve& front);

} // namespace spricka::mesh
