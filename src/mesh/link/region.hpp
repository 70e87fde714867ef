// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <array>
#include <string>
#include <type_traits>
#include <vector>

namespace spricka::mesh {

/// A region of the plane (dim 2) or of space (dim 3) to be filled with triangles or tetrahedra that
/// use every given edge or triangle as a side.
template <int dim> struct FillRegion {
  /// In the plane a polygon of points, in space triangles.
  using Boundary = std::vector<std::conditional_t<dim == 2, int, std::array<int, 3>>>;

  std::vector<Eigen::Matrix<double, dim, 1>> points;
  /// Closed. Polygons have the region on their left; of surfaces that which encloses the others
  /// comes first.
  std::vector<Boundary> boundaries;
  std::vector<Boundary> embedded; ///< inside; their ends or rims lie inside or on boundaries
};
using PlaneRegion = FillRegion<2>;
using SolidRegion = FillRegion<3>;

/// What fills a region.
template <int dim> struct MeshFill {
  std::vector<Eigen::Matrix<double, dim, 1>> added; ///< points that follow those of the region
  std::vector<std::array<int, dim + 1>> cells;      ///< anticlockwise; of positive volume
  std::string trouble;                              ///< what the mesher said, if it failed
};
using TriangleFill = MeshFill<2>;
using TetrahedronFill = MeshFill<3>;

} // namespace spricka::mesh
