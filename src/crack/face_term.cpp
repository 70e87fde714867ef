// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/face_term.hpp"

#include "crack/load_fields.hpp"
#include "crack/plane_side.hpp"

namespace spricka::crack {

namespace {

// Where the load at the tip is taken: off the tip by this part of the way to the side's middle.
constexpr double beside = 1e-9;

struct ScaledLoad {
  const ActingLoad& acting;
  fe::FieldScale scale;
};

// t . u,1 needs no gradient of the element: along the face u,1 ds is the derivative of u by the
// reference coordinate, and finite where a quarter-point element's gradients are not.
void add_face(const TipSetting& set, const ScaledLoad& on, const model::Face& face,
              const base::Vector& u, ConfigurationalForces& out) {
  const auto& [acting, scale] = on;
  const PlaneSide side(set.mesh, face);
  const SideVectors U = side.gather(u);
  const SideVectors R = side.positions_from_tip(set.tip.x);
  for (const auto& point : fe::load_rule<1>(side.shape, side.X, *acting.load, scale).points) {
    const SideValues dN = side.shape.dN(point.r);
    const SideValues N = side.shape.N(point.r);
    const base::Vec2 x = side.X.topRows<2>() * N;
    const base::Vec2 along = R * dN; // dx/dr, the body on the left
    const base::Vec2 from = R * N;
    if (!(from.squaredNorm() > 0.0 && along.squaredNorm() > 0.0)) {
      continue; // the tip itself, a point without a length
    }
    const base::Vec2 tangent = along.normalized();
    const base::Vec2 normal(tangent.y(), -tangent.x());
    const base::Vec2 t = set.relative_depth(x) * traction(acting, x, normal);
    const Polar place = polar_on_face({{0.0, 0.0}, set.tip.e1, set.tip.e2}, from, normal);
    for (std::size_t k = 0; k < auxiliary_field_count; ++k) {
      const base::Vec2 du =
          k == 0 ? base::Vec2(U * dN) : base::Vec2(auxiliary_field_gradient(set, place, k) * along);
      // (crack.20): du goes along the face, and the tangent's part along e1 gives it the sign of
      // u,1 ds.
      const base::Vec2 work = -point.weight * t.dot(du) * tangent;
      for (std::size_t i = 0; i < side.nodes.size(); ++i) {
        out[side.nodes[i]][k].head<2>() += N[static_cast<Eigen::Index>(i)] * work;
      }
    }
  }
}

} // namespace

void add_face_terms(const TipSetting& set, const base::Vector& u, ConfigurationalForces& out) {
  for (const ActingLoad& acting : set.loads.loads) {
    const ScaledLoad on{acting, face_scale(set, acting)};
    for (const model::Face& face : acting.faces) {
      add_face(set, on, face, u, out);
    }
  }
}

double stress_on_crack_faces_at_tip(const TipSetting& set, const mesh::CrackFront& front) {
  double sum = 0.0;
  for (const ActingLoad& acting : set.loads.loads) {
    for (const model::Face& face : acting.faces) {
      const PlaneSide side(set.mesh, face);
      const base::Vec2 along = (side.X.col(1) - side.X.col(0)).head<2>().normalized();
      const base::Vec2 middle = 0.5 * (side.X.col(0) + side.X.col(1)).head<2>();
      const base::Vec2 normal(along.y(), -along.x());
      const bool behind = (middle - set.tip.x).dot(set.tip.e1) < 0.0; // a half model has more
      if (behind &&
          (side.nodes[0] == front.tip_point().node || side.nodes[1] == front.tip_point().node)) {
        // on the crack face, should the load end at the tip
        const base::Vec2 x = set.tip.x + beside * (middle - set.tip.x);
        sum += normal.dot(traction(acting, x, normal));
      }
    }
  }
  // The mean of both faces; a half has one.
  return front.symmetric_half ? sum : 0.5 * sum;
}

} // namespace spricka::crack
