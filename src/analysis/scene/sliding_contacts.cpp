// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene/sliding_contacts.hpp"

#include "fe/dependence.hpp"

namespace spricka::analysis {

namespace {

std::vector<contact::SurfaceNodeNormal> independent_points(const Discretisation& scene,
                                                           const contact::ContactSurface& surface) {
  const int dim = scene.cracked.mesh.dim;
  std::vector<contact::SurfaceNodeNormal> points = contact::surface_node_normals(surface);
  std::erase_if(points, [&](const contact::SurfaceNodeNormal& point) {
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

std::vector<contact::ContactRowSurfaces> pressing_contact_surfaces(const Discretisation& scene) {
  std::vector<contact::ContactRowSurfaces> found;
  for (std::size_t c = 0; c < scene.pairs.size(); ++c) {
    const contact::PairConstraints& pair = scene.pairs[c];
    if (pair.faces || scene.contacts[c].type == model::ContactType::bonded) {
      continue;
    }
    contact::ContactRowSurfaces& own = found.emplace_back();
    own.first = scene.table.first[c];
    for (const contact::ConstraintRow& row : pair.normal) {
      own.area.push_back(row.area);
    }
    own.surface = {independent_points(scene, pair.contact), independent_points(scene, pair.target)};
  }
  return found;
}

} // namespace spricka::analysis
