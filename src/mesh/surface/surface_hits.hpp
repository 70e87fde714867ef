// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/surface/surface_geometry.hpp"

#include <functional>
#include <optional>
#include <vector>

/// Lines through space that meet the surface of a body.
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
bool is_inside(const SurfaceGeometry& surface, const base::Vec3& x);

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

} // namespace spricka::mesh
