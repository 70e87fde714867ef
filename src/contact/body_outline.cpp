// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/body_outline.hpp"

#include "model/mesh.hpp"

namespace spricka::contact {

BodyOutline::BodyOutline(const model::Model& model, const model::Mesh& mesh,
                         const std::vector<model::Face>& faces, const base::Vector& u) {
  if (mesh.dim == 3) {
    space_.emplace(mesh, faces, u);
    low_ = space_->low();
    high_ = space_->high();
    return;
  }
  plane_.emplace(make_surface(model, mesh, faces), u);
  low_.head<2>() = plane_->low();
  high_.head<2>() = plane_->high();
}

std::optional<OutlinePlace> BodyOutline::nearest(const base::Vec3& x, double reach) const {
  if (plane_) {
    return plane_->nearest(x.head<2>(), reach);
  }
  const std::optional<HullPlace> at = space_->nearest(x, reach);
  return at ? std::optional(OutlinePlace{at->distance, at->facet}) : std::nullopt;
}

bool boxes_meet(const BodyOutline& one, const BodyOutline& two) {
  return (one.high() - two.low()).minCoeff() >= 0.0 && (two.high() - one.low()).minCoeff() >= 0.0;
}

} // namespace spricka::contact
