// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "geometry/box_tree.hpp"
#include "mesh/link/grading.hpp"
#include "mesh/link/region.hpp"
#include "mesh/surface/chart_maps.hpp"
#include "mesh/surface/new_surface.hpp"

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// A patch of the surface laid flat, and what is to be filled of it there.
namespace spricka::mesh {

/// A patch of the surface laid flat, there and back: parameters in lengths of the crack.
class SurfaceChart {
public:
  /// The surface must outlive the chart.
  SurfaceChart(const SurfaceGeometry& surface, const std::vector<std::size_t>& faces,
               const CrackReferencePlane& plane);

  /// What kept the patch from being laid flat.
  [[nodiscard]] const SurfaceFailure& failure() const { return trouble_; }
  /// Rounded parameters of a place on one of the patch's faces.
  [[nodiscard]] base::Vec2 at(std::size_t face, const base::Vec2& r) const;
  /// The place with these parameters, on a true face; beyond the border the nearest.
  [[nodiscard]] SurfacePlace map_to_surface(const base::Vec2& u) const;
  /// The place half way between two, whose parameters these are: of a plane exactly.
  [[nodiscard]] SurfacePlace midpoint(const SurfacePlace& a, const SurfacePlace& b,
                                      const base::Vec2& ua, const base::Vec2& ub) const;
  /// Length in parameters for one in space, thereabouts.
  [[nodiscard]] double parameter_scale(const base::Vec2& u) const;

private:
  struct BarycentricPoint {
    std::size_t facet = 0;
    Eigen::Vector3d hat = Eigen::Vector3d::Zero();
  };
  struct FacePointAtParameters {
    std::size_t face = nowhere;
    base::Vec2 r = base::Vec2::Zero();
    double off = 0.0; ///< in parameters
  };
  void flatten_onto_plane(const CrackReferencePlane& plane);
  void sort_facets();
  [[nodiscard]] BarycentricPoint find(const base::Vec2& u) const;
  [[nodiscard]] Eigen::Vector3d hats(std::size_t facet, const base::Vec2& u) const;
  [[nodiscard]] FacePointAtParameters flat_on(std::size_t face, base::Vec2 r,
                                              const base::Vec2& u) const;
  [[nodiscard]] FacePointAtParameters flat_place(std::size_t face, const base::Vec2& r,
                                                 const base::Vec2& u) const;

  const SurfaceGeometry& surface_;
  std::vector<std::size_t> faces_;
  FacetTriangulation net_;
  SurfaceFailure trouble_;
  std::optional<ChartPlaneFrame> flat_;  ///< of a plane patch, whose parameters are exact
  FlattenedVertexCoordinates u_;         ///< [vertex]
  geometry::BoxTree<2> facets_;          ///< by their parameters
  geometry::Box<2> extent_;              ///< of all parameters
  base::Vec2 room_ = base::Vec2::Zero(); ///< in which the facets near a place are sought
};

/// What is to be filled of one patch: its lines in parameters.
struct ChartOutline {
  PlaneRegion region;     ///< points in parameters, loops with the patch on their left
  std::vector<int> point; ///< [point of the region] point of the new surface

  /// The region's number of a point of the new surface, which is taken in with its parameters if it
  /// is not yet there.
  int find_or_add_region_point(int of_surface, const base::Vec2& u);

private:
  std::map<int, int> known_;
};

/// A mistake of lines that cross or run over each other, where a mesher would give up or worse: the
/// points of the region at the two edges.
struct LineIntersection {
  std::pair<int, int> one, two;
  bool outside = false; ///< a cap (`one`) that does not lie in the patch
};

/// The first mistake found: edges of loops and embedded lines that meet other than in their ends,
/// or loops from `first_cap` on that lie outside of the others.
std::optional<LineIntersection> find_line_intersection(const PlaneRegion& region,
                                                       std::size_t first_cap);

/// Sizes in parameters: as wanted on the surface, and those of the lines where they are finer.
Grading chart_grading(const SurfaceChart& chart, const PlaneRegion& region,
                      const SizeFunction& size, double growth);

} // namespace spricka::mesh
