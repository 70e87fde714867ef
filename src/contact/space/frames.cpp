// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space/frames.hpp"

#include <Eigen/Geometry>

namespace spricka::contact {

SurfaceFrames::SurfaceFrames(const FacetSurface& surface) {
  if (surface.facets.empty() || surface.facets.front().is_edge()) {
    return;
  }
  std::vector<Vec3> most(surface.rounds.size(), Vec3::Zero()); // |n| along x, y, z
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    const geometry::ElementSide& face = surface.facets[f];
    const geometry::SidePoint centre = face.point(face.domain_centre());
    Vec3& part = most[surface.part[f]];
    part = part.cwiseMax(surface_normal(surface, f, centre).cwiseAbs());
  }
  for (std::size_t p = 0; p < most.size(); ++p) {
    const std::optional<AnalyticShape>& round = surface.rounds[p];
    Eigen::Index least = 0;
    most[p].minCoeff(&least);
    axis_.push_back(round && is_cylinder_or_cone(*round) ? round->axis : Vec3(Vec3::Unit(least)));
  }
}

std::array<Vec3, 3> SurfaceFrames::at(std::size_t part, const Vec3& n) const {
  constexpr double along_normal = 1e-6; // a part all round: where the axis leaves it any will do
  if (axis_.empty()) {
    return {n, Vec3::UnitZ().cross(n), Vec3::UnitZ()};
  }
  const Vec3& a = axis_[part];
  const Vec3 across = a - a.dot(n) * n;
  const Vec3 t = across.norm() > along_normal ? across.normalized() : n.unitOrthogonal();
  return {n, t, n.cross(t)};
}

} // namespace spricka::contact
