// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <array>
#include <string>
#include <vector>

namespace spricka::mesh {

/// A region of space to be filled with tetrahedra that use every given triangle as a side.
struct SolidRegion {
  using Triangle = std::array<int, 3>;
  std::vector<base::Vec3> points;
  std::vector<std::vector<Triangle>> shells; ///< closed; the one that encloses the others first
  std::vector<Triangle> embedded;            ///< inside; their rims lie inside or on shells
};

/// Element size in space: each source asks for its size up to a radius round its place, and lets it
/// grow with the distance beyond; the smallest wins.
struct SolidGrading {
  struct SolidSizeSource {
    base::Vec3 at = base::Vec3::Zero();
    double radius = 0.0;
    double size = 1.0;
    double growth = 0.3; ///< of the size for each unit of distance
  };
  std::vector<SolidSizeSource> sources;

  [[nodiscard]] double operator()(const base::Vec3& p) const;
};

struct TetrahedronFill {
  std::vector<base::Vec3> added;              ///< points that follow those of the region
  std::vector<std::array<int, 4>> tetrahedra; ///< of positive volume
  std::string trouble;                        ///< what the mesher said, if it failed
};

} // namespace spricka::mesh
