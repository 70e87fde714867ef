// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/surface/surface_trace.hpp"

#include <array>
#include <vector>

/// The part of a body's surface that a cavity takes away, and what it becomes.
namespace spricka::mesh {

/// Where a line of a mouth ends: at a corner of a cap's outline, or (cap < 0) free.
struct MouthEnd {
  int cap = -1;
  int corner = -1;
};

struct SurfaceMouth {
  DividedTrace line; ///< of divide_trace_by_size(); end places are those of the caps' corners
  std::array<MouthEnd, 2> end; ///< of its first and last corner
  bool closed = false;         ///< its last corner is the first one again, both are free
};

/// What is to be meshed.
struct SurfaceRegion {
  /// Boundary faces that the cavity removes, by their numbers in the SurfaceGeometry.
  std::vector<std::size_t> faces;
  /// Outlines of the tube's ends, closed polygons of points on those faces, either way round. What
  /// they enclose stays free. Each lies on one smooth piece.
  std::vector<std::vector<base::Vec3>> caps;
  std::vector<SurfaceMouth> mouths;
  CrackReferencePlane plane; ///< of the crack: for rounded coordinates
  SizeFunction size;
  double growth = 0.3; ///< of the size for each unit of distance
};

/// What an edge of the new mesh is. Its middle is fixed for all but `outline`, whose tube has one.
enum class RemeshedEdgeKind {
  rim,     ///< of the host, to a face that stays
  feature, ///< part of a feature edge of the host
  outline, ///< of a tube's end
  mouth,   ///< of the crack
  inner,   ///< between two of the new triangles
};

struct RemeshedEdge {
  std::array<int, 2> points{-1, -1}; ///< the lower first
  RemeshedEdgeKind kind = RemeshedEdgeKind::inner;
  SurfacePlace mid;      ///< on the host's true face
  base::NodeId host_mid; ///< of a rim of quadratic elements
  /// Of a feature one of the host's edges that it lies on; all of these have the same lines.
  std::size_t host_edge = nowhere;
};

struct RemeshedPoint {
  SurfacePlace place;
  base::NodeId host; ///< on the rim, and where a line of nodes has one
};

struct RemeshedTriangle {
  std::array<int, 3> points{-1, -1, -1}; ///< round the outer normal
  std::array<int, 3> edges{-1, -1, -1};  ///< [i] from point i to the next
  std::size_t face = nowhere;            ///< the host's face that its middle lies on
};

/// The region as quadratic triangles.
struct RemeshedSurface {
  std::vector<RemeshedPoint> points;
  std::vector<RemeshedEdge> edges;
  std::vector<RemeshedTriangle> triangles;
  std::vector<std::vector<int>> caps;   ///< [cap][corner] point, as given
  std::vector<std::vector<int>> mouths; ///< [mouth][corner of its line] point
  SurfaceFailure trouble;               ///< then there is nothing else
};

/// What is wrong with a new surface: triangles that fold or look into the body, edges of a kind
/// that do not have as many triangles as they should. Empty if nothing is.
SurfaceFailure find_remeshed_surface_fault(const SurfaceGeometry& surface,
                                           const RemeshedSurface& made);

/// Normal of a curved triangle at the reference place r (not unit: twice the area of the plane
/// one).
base::Vec3 triangle_normal(const RemeshedSurface& made, const RemeshedTriangle& triangle,
                           const base::Vec2& r);

} // namespace spricka::mesh
