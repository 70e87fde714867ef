// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/body_outline.hpp"

#include "model/mesh.hpp"

namespace spricka::contact {

BodyBoundary::BodyBoundary(const model::Model& model, const model::Mesh& mesh,
                           const std::vector<model::Face>& faces, const base::Vector& u) {
  if (mesh.dim == 3) {
    space_.emplace(mesh, faces, u);
    low_ = space_->lower_corner();
    high_ = space_->upper_corner();
    return;
  }
  plane_.emplace(make_surface(model, mesh, faces), u);
  low_.head<2>() = plane_->lower_corner();
  high_.head<2>() = plane_->upper_corner();
}

std::optional<BoundaryDistance> BodyBoundary::signed_distance(const base::Vec3& x,
                                                              double reach) const {
  if (plane_) {
    return plane_->signed_distance(x.head<2>(), reach);
  }
  const std::optional<TriangulationDistance> at = space_->signed_distance(x, reach);
  return at ? std::optional(BoundaryDistance{at->distance, at->facet}) : std::nullopt;
}

bool boxes_meet(const BodyBoundary& one, const BodyBoundary& two) {
  return (one.upper_corner() - two.lower_corner()).minCoeff() >= 0.0 &&
         (two.upper_corner() - one.lower_corner()).minCoeff() >= 0.0;
}

} // namespace spricka::contact
