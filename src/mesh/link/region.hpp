// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <array>
#include <string>
#include <vector>

namespace spricka::mesh {

/// A plane region to be filled with triangles that use every given edge as it is.
struct PlaneRegion {
  std::vector<base::Vec2> points;
  std::vector<std::vector<int>> loops;    ///< closed polygons of points, region on the left
  std::vector<std::vector<int>> embedded; ///< polygons inside, ends on the loops or free
};

struct TriangleFill {
  std::vector<base::Vec2> added;             ///< points that follow those of the region
  std::vector<std::array<int, 3>> triangles; ///< anticlockwise
  std::string trouble;                       ///< what the mesher said, if it failed
};

} // namespace spricka::mesh
