// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/tip_stress.hpp"

#include "fe/thermal_kernel.hpp"
#include "model/mesh_side.hpp"

namespace spricka::crack {

namespace {

// Where the load at the tip is taken: off the tip by this part of the way to the side's middle.
constexpr double beside = 1e-9;

} // namespace

double stress_on_crack_faces_at_tip(const TipContext& set, const mesh::CrackFront& front) {
  double sum = 0.0;
  for (const ActingLoad& acting : set.loads.loads) {
    for (const model::Face& face : acting.faces) {
      const geometry::ElementSide side = model::element_side(set.mesh, face);
      const base::Vec2 along = (side.X.col(1) - side.X.col(0)).head<2>().normalized();
      const base::Vec2 middle = 0.5 * (side.X.col(0) + side.X.col(1)).head<2>();
      const base::Vec2 normal(along.y(), -along.x());
      const bool behind = (middle - set.tip.x).dot(set.tip.e1) < 0.0; // a half model has more
      if (behind &&
          (side.nodes[0] == front.tip_point().node || side.nodes[1] == front.tip_point().node)) {
        // on the crack face, should the load end at the tip
        const base::Vec2 x = set.tip.x + beside * (middle - set.tip.x);
        sum += normal.dot(
            load_force_on_face(acting, {x.x(), x.y(), 0.0}, {normal.x(), normal.y(), 0.0})
                .head<2>());
      }
    }
  }
  // The mean of both faces; a half has one.
  return front.symmetric_half ? sum : 0.5 * sum;
}

double thermal_stress_at_tip(const TipContext& set, const mesh::CrackFront& front) {
  if (set.loads.temperature.size() == 0) {
    return 0.0;
  }
  double sum = set.affine ? set.affine->at_tip : 0.0;
  int count = set.affine ? 1 : 0;
  for (std::size_t i = 0; i < set.mesh.nodes.size() && !set.affine; ++i) {
    if (set.mesh.nodes[i] == front.tip_point().node) { // a corner of its elements
      sum += set.loads.temperature[static_cast<Eigen::Index>(i)];
      ++count;
    }
  }
  return fe::effective_modulus(set.material, set.state()) * set.section_expansion_coefficient() *
         sum / std::max(count, 1);
}

} // namespace spricka::crack
