// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/surface/surface_geometry.hpp"
#include "mesh/surface/surface_trace.hpp"

#include <optional>
#include <vector>

/// Ways to lay a patch of the surface flat: a place of the plane for each vertex of its facets, in
/// lengths of the crack, none of the facets turned over.
namespace spricka::mesh {

using FlattenedVertexCoordinates = std::vector<base::Vec2>; ///< [vertex]

/// A patch cut out of the surface, all of it on one smooth piece and connected.
struct ChartPatch {
  const SurfaceGeometry& surface;
  const std::vector<std::size_t>& faces;
  const FacetTriangulation& net;
  const CrackReferencePlane& plane;
};

/// Axes of a plane with the crack's origin.
struct ChartPlaneFrame {
  base::Vec3 origin, e1, e2;
  double length = 1.0;
  [[nodiscard]] base::Vec2 operator()(const base::Vec3& x) const {
    return base::Vec2((x - origin).dot(e1), (x - origin).dot(e2)) / length;
  }
};
/// Of a plane patch; none of others.
std::optional<ChartPlaneFrame> frame_of_plane_patch(const ChartPatch& patch);
/// Straight onto a plane across the mean normal.
ChartPlaneFrame mean_plane_frame(const ChartPatch& patch);

/// A circular cylinder unrolled; where the patch goes all the way round, by the exponential
/// function, which keeps angles too, onto a ring. None if it is no cylinder.
std::optional<FlattenedVertexCoordinates> unroll_cylinder(const ChartPatch& patch);

/// Angles kept as well as can be, by least squares (Levy, Petitjean, Ray and Maillot 2002), total
/// area kept; none if the equations have no solution.
std::optional<FlattenedVertexCoordinates> conformal_map(const ChartPatch& patch);

/// Whether all facets lie face up.
bool has_no_inverted_facets(const FacetTriangulation& net,
                            const FlattenedVertexCoordinates& places);

} // namespace spricka::mesh
