// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/outline.hpp"
#include "contact/space/hull.hpp"
#include "model/forward.hpp"

#include <optional>
#include <vector>

namespace spricka::contact {

/// The boundary of a body, in the plane an outline, in space a hull: to ask whether points lie
/// inside.
class BodyBoundary {
public:
  /// The sides `faces` of a body, moved by u [dim * node] [length]; empty: as drawn.
  BodyBoundary(const model::Model& model, const model::Mesh& mesh,
               const std::vector<model::Face>& faces, const base::Vector& u);

  /// The nearest place no further off than `reach`, if there is one.
  [[nodiscard]] std::optional<BoundaryDistance> signed_distance(const base::Vec3& x,
                                                                double reach) const;
  /// Corners of the bounding box; z is 0 in the plane.
  [[nodiscard]] const base::Vec3& lower_corner() const { return low_; }
  [[nodiscard]] const base::Vec3& upper_corner() const { return high_; }
  [[nodiscard]] double extent() const { return (high_ - low_).norm(); }

private:
  std::optional<BoundaryPolyline> plane_;
  std::optional<BoundaryTriangulation> space_;
  base::Vec3 low_ = base::Vec3::Zero(), high_ = base::Vec3::Zero();
};

/// Whether the bounding boxes meet: without that bodies do not.
bool boxes_meet(const BodyBoundary& one, const BodyBoundary& two);

} // namespace spricka::contact
