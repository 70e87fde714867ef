// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/space/facet_surface.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace spricka::contact {

/// Directions of rows on a surface: its normal and its tangents. In the plane the first tangent is
/// the normal turned to the left. In space there are two, the first along the axis of a
/// cylinder or cone, else along the axis of the coordinates that is farthest from all normals of
/// the part; one for all of a part, as rows are sums over it.
class SurfaceFrames {
public:
  explicit SurfaceFrames(const FacetSurface& surface);
  /// Normal and tangents, right-handed, where the unit normal of a part is n.
  [[nodiscard]] std::array<Vec3, 3> at(std::size_t part, const Vec3& n) const;

  /// How many directions there are: 2 in the plane, 3 in space.
  [[nodiscard]] std::size_t count() const { return axis_.empty() ? 2 : 3; }

private:
  std::vector<Vec3> axis_; ///< [part] in space; none in the plane
};

} // namespace spricka::contact
