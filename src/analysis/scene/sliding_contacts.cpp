// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene/sliding_contacts.hpp"

#include "fe/dependence.hpp"

namespace spricka::analysis {

namespace {

std::vector<contact::SurfacePoint> independent_points(const Scene& scene,
                                                      const contact::Surface& surface) {
  const int dim = scene.cracked.mesh.dim;
  std::vector<contact::SurfacePoint> points = contact::surface_points(surface);
  std::erase_if(points, [&](const contact::SurfacePoint& point) {
    for (int c = 0; c < dim; ++c) {
      if (scene.ties->find_row(static_cast<std::int32_t>(point.node.index()) * dim + c) !=
          nullptr) {
        return true;
      }
    }
    return false;
  });
  return points;
}

} // namespace

std::vector<contact::SlidingContact> sliding_contacts(const Scene& scene) {
  std::vector<contact::SlidingContact> found;
  for (std::size_t c = 0; c < scene.pairs.size(); ++c) {
    const contact::PairRows& pair = scene.pairs[c];
    if (pair.faces || scene.contacts[c].type == model::ContactType::bonded) {
      continue;
    }
    contact::SlidingContact& own = found.emplace_back();
    own.first = scene.table.first[c];
    for (const contact::ConstraintRow& row : pair.normal) {
      own.area.push_back(row.area);
    }
    own.surface = {independent_points(scene, pair.contact), independent_points(scene, pair.target)};
  }
  return found;
}

} // namespace spricka::analysis
