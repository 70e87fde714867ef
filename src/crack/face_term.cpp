// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/face_term.hpp"

#include "crack/load_fields.hpp"
#include "fe/face.hpp"

namespace spricka::crack {

namespace {

template <shape::Shape Side>
Eigen::Matrix<double, 2, Side::nodes> displacements(const std::array<base::NodeId, Side::nodes>& at,
                                                    const base::Vector& u) {
  Eigen::Matrix<double, 2, Side::nodes> U;
  for (std::size_t i = 0; i < at.size(); ++i) {
    U.col(static_cast<Eigen::Index>(i)) =
        u.segment<2>(2 * static_cast<Eigen::Index>(at[i].index()));
  }
  return U;
}

// Where the load at the tip is taken: off the tip by this part of the way to the side's middle.
constexpr double beside = 1e-9;

struct ScaledLoad {
  const ActingLoad& acting;
  fe::FieldScale scale;
};

// Nodes of a side as seen from the tip: of points much nearer to it than sixteen digits of their
// coordinates tell, as a rule has them where a load jumps at the tip, the distance is right even
// so.
template <shape::Shape Side>
Eigen::Matrix<double, 2, Side::nodes> from_tip(const TipSetting& set,
                                               const fe::SideNodes<Side>& X) {
  return X.template topRows<2>().colwise() - set.tip.x;
}

// t . u,1 needs no gradient of the element: along the face u,1 ds is the derivative of u by the
// reference coordinate, and finite where a quarter-point element's gradients are not.
template <shape::Shape Side>
void add_face(const TipSetting& set, const ScaledLoad& on, const model::Face& face,
              const base::Vector& u, NodalForces& out) {
  const auto& [acting, scale] = on;
  const fe::SideNodes<Side> X = fe::side_coordinates<Side>(set.mesh, face);
  const auto nodes = fe::nodes_of_face<Side>(set.mesh, face);
  const Eigen::Matrix<double, 2, Side::nodes> U = displacements<Side>(nodes, u);
  const Eigen::Matrix<double, 2, Side::nodes> R = from_tip<Side>(set, X);
  for (const auto& point : fe::load_rule<Side>(X, *acting.load, scale).points) {
    const auto dN = Side::dN(point.r);
    const auto N = Side::N(point.r);
    const base::Vec2 x = (X * N).template head<2>();
    const base::Vec2 along = R * dN; // dx/dr, the body on the left
    const base::Vec2 from = R * N;
    if (!(from.squaredNorm() > 0.0 && along.squaredNorm() > 0.0)) {
      continue; // the tip itself, a point without a length
    }
    const base::Vec2 tangent = along.normalized();
    const base::Vec2 normal(tangent.y(), -tangent.x());
    const base::Vec2 t = set.depth(x) * traction(acting, x, normal);
    const Polar place = polar_on_face({{0.0, 0.0}, set.tip.e1, set.tip.e2}, from, normal);
    for (std::size_t k = 0; k < partners; ++k) {
      const base::Vec2 du =
          k == 0 ? base::Vec2(U * dN) : base::Vec2(partner_gradient(set, place, k) * along);
      // (crack.20): du goes along the face, and the tangent's part along e1 gives it the sign of
      // u,1 ds.
      const base::Vec2 work = -point.weight * t.dot(du) * tangent;
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        out[nodes[i]][k].template head<2>() += N[static_cast<Eigen::Index>(i)] * work;
      }
    }
  }
}

} // namespace

void add_face_terms(const TipSetting& set, const base::Vector& u, NodalForces& out) {
  for (const ActingLoad& acting : set.loads.loads) {
    const ScaledLoad on{acting, face_scale(set, acting)};
    fe::for_edges(set.mesh, acting.faces, [&]<shape::Shape Side>(Side, const model::Face& face) {
      add_face<Side>(set, on, face, u, out);
    });
  }
}

double stress_on_crack_faces_at_tip(const TipSetting& set, const mesh::Front& front) {
  double sum = 0.0;
  for (const ActingLoad& acting : set.loads.loads) {
    fe::for_edges(set.mesh, acting.faces, [&]<shape::Shape Side>(Side, const model::Face& face) {
      const auto nodes = fe::nodes_of_face<Side>(set.mesh, face);
      const fe::SideNodes<Side> X = fe::side_coordinates<Side>(set.mesh, face);
      const base::Vec2 along = (X.col(1) - X.col(0)).template head<2>().normalized();
      const base::Vec2 middle = 0.5 * (X.col(0) + X.col(1)).template head<2>();
      const base::Vec2 normal(along.y(), -along.x());
      const bool behind = (middle - set.tip.x).dot(set.tip.e1) < 0.0; // a half model has more
      if (behind && (nodes[0] == front.tip().node || nodes[1] == front.tip().node)) {
        // on the crack face, should the load end at the tip
        const base::Vec2 x = set.tip.x + beside * (middle - set.tip.x);
        sum += normal.dot(traction(acting, x, normal));
      }
    });
  }
  // The mean of both faces; a half has one.
  return front.symmetric_half ? sum : 0.5 * sum;
}

} // namespace spricka::crack
