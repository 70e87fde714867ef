// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/surface/crack_relief.hpp"
#include "mesh/surface/surface_geometry.hpp"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

/// Lines on the surface of a body: where the plane of a crack meets it, or what the crack has made
/// of that plane; and their division into edges.
namespace spricka::mesh {

/// Why something could not be made, in words, and where. Empty words: it was made.
struct SurfaceFailure {
  std::string why;
  base::Vec3 at = base::Vec3::Zero();
  explicit operator bool() const { return !why.empty(); }
};

/// The plane of a crack: a point of it, its unit normal b, a length of the crack (its size, or that
/// of its front), and a direction in it that goes with the crack. Decisions are taken on
/// coordinates about that point, divided by that length and rounded, so that units and place of a
/// model do not change a mesh.
struct CrackReferencePlane {
  base::Vec3 origin = base::Vec3::Zero();
  base::Vec3 normal = base::Vec3::UnitZ();
  double length = 1.0;
  base::Vec3 axis = base::Vec3::UnitX(); ///< unit
  /// Where the crack has turned out of it; empty: nowhere.
  std::shared_ptr<const NonPlanarCrackSurface> relief = nullptr;

  /// Distance of a point from the plane along its normal, signed; with a relief from the plane
  /// through the first point of the first front [length].
  [[nodiscard]] double signed_plane_distance(const base::Vec3& x) const {
    return (x - (relief ? relief->fronts().points.front().front() : origin)).dot(normal);
  }
  /// Of a place over the crack.
  [[nodiscard]] double height_over_crack(const base::Vec3& x) const {
    return relief ? -relief->crack_height_over_plane(x) : signed_plane_distance(x);
  }
  /// How that height changes in space.
  [[nodiscard]] base::Vec3 gradient_of_height_over_crack(const base::Vec3& x) const {
    return relief ? base::Vec3(normal - relief->crack_height_gradient(x)) : normal;
  }
};

/// A point of a line on the surface.
struct TracePoint {
  SurfacePlace place;
  std::size_t edge = nowhere; ///< the feature edge that the line crosses here, if it does
  double t = 0.0;             ///< the place on that edge [-1,1]
};

/// The way of a plane over the surface from one place to another.
class SurfaceTrace {
public:
  /// A straight stretch in reference coordinates of one face.
  struct TraceSegment {
    std::size_t face = nowhere;
    base::Vec2 r0, r1;
    double s = 0.0; ///< length of the trace at r0
  };
  SurfaceTrace(const SurfaceGeometry& surface, const CrackReferencePlane& plane,
               std::vector<TracePoint> points, std::vector<TraceSegment> segments);

  [[nodiscard]] double length() const { return arc_.back(); }
  /// Points in their order, first and last included, several on each curved face, one at each edge
  /// that is crossed; all of them on the plane and the true faces.
  [[nodiscard]] const std::vector<TracePoint>& points() const { return points_; }
  /// [point] length up to it, along chords.
  [[nodiscard]] const std::vector<double>& arc_lengths() const { return arc_; }
  /// The place at a length s, on the plane and the true face.
  [[nodiscard]] SurfacePlace at(double s) const;
  /// Lengths at which a crack that has turned does so by more than an angle [rad], ascending.
  [[nodiscard]] std::vector<double> kink_positions(double angle) const;

private:
  const SurfaceGeometry* surface_;
  CrackReferencePlane plane_;
  std::vector<TracePoint> points_;
  std::vector<TraceSegment> segments_; ///< one less than points
  std::vector<double> arc_;
};

struct TraceResult {
  std::vector<SurfaceTrace> trace; ///< one, or none with trouble
  SurfaceFailure trouble;
};

/// The line of the plane on the surface from one place to another, both on the plane; it leaves
/// `from` to the side of `towards`. The surface must outlive the trace.
TraceResult trace_crack_plane(const SurfaceGeometry& surface, const CrackReferencePlane& plane,
                              const SurfacePlace& from, const SurfacePlace& to,
                              const base::Vec3& towards);

/// A size of elements wanted at a point of space [length].
using SizeFunction = std::function<double(const base::Vec3&)>;

/// A line on the surface divided into edges: corners, and a middle between each two, all on the
/// plane and the true faces.
struct DividedTrace {
  std::vector<TracePoint> corners;
  std::vector<SurfacePlace> mids; ///< one less
};

/// Angle [rad] from which on a crack that has turned has edges along the bend.
inline constexpr double bent = 0.03;

/// Divides a trace into edges of the wanted sizes. Where it crosses feature edges or is bent there
/// are corners.
DividedTrace divide_trace_by_size(const SurfaceTrace& trace, const SizeFunction& size);

} // namespace spricka::mesh
