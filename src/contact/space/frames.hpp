// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/space/space_surface.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace spricka::contact {

/// Directions of rows on a surface: its normal and two tangents, the first along the axis of a
/// cylinder or cone, else along the axis of the coordinates that is farthest from all normals of
/// the part; one for all of a part, as rows are sums over it.
class SurfaceFrames {
public:
  explicit SurfaceFrames(const SpaceSurface& surface);
  /// Normal and tangents, right-handed, where the unit normal of a part is n.
  [[nodiscard]] std::array<Vec3, 3> at(std::size_t part, const Vec3& n) const;

private:
  std::vector<Vec3> axis_; ///< [part]
};

} // namespace spricka::contact
