// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/link/grading.hpp"
#include "mesh/link/region.hpp"
#include "mesh/surface/new_surface.hpp"
#include "mesh/surface/surface_chart.hpp"

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace spricka::mesh {

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
