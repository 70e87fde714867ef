// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/space/face_forces.hpp"

#include "crack/space/front_rule.hpp"
#include "crack/space/solid_blocks.hpp"
#include "fe/face.hpp"
#include "shape/quadrature.hpp"

#include <map>

namespace spricka::crack {

using base::Vec3;

namespace {

template <shape::Shape Side>
fe::SideNodes<Side> displacements(const std::array<base::NodeId, Side::nodes>& at,
                                  const base::Vector& u) {
  fe::SideNodes<Side> U;
  for (std::size_t i = 0; i < at.size(); ++i) {
    U.col(static_cast<Eigen::Index>(i)) =
        u.segment<3>(3 * static_cast<Eigen::Index>(at[i].index()));
  }
  return U;
}

} // namespace

void add_face_forces(const FrontSetting& set, const FrontFields& fields,
                     const std::vector<FaceForces>& forces, const base::Vector& u,
                     FrontForces& out) {
  std::map<model::Face, FaceSide> moved;
  for (const FrontSide& side : fields.sides) {
    moved.emplace(side.face, side.on);
  }
  for (const FaceForces& on : forces) {
    const auto known = moved.find(on.face);
    if (known == moved.end()) {
      continue;
    }
    fe::with_side(set.mesh, on.face, [&]<shape::Shape Side>(Side) {
      if constexpr (Side::dim == 2) {
        const fe::SideNodes<Side> X = fe::side_coordinates<Side>(set.mesh, on.face);
        const auto nodes = fe::nodes_of_face<Side>(set.mesh, on.face);
        const fe::SideNodes<Side> U = displacements<Side>(nodes, u);
        for (const fe::LoadPoint& point : on.points) {
          const shape::Point<2> r = point.r.head<2>();
          const Eigen::Matrix<double, Side::nodes, 1> N = Side::N(r);
          const FrontPlace place = set.axes.place(X * N, known->second);
          if (!(place.r > 0.0)) {
            continue; // the front itself, a line without an area
          }
          for (std::size_t k = 0; k < front_partners; ++k) {
            const Tensor<3> H = k == 0 ? Tensor<3>(U * surface_gradients<Side>(X, r))
                                       : moving_field(k, place, set.body).H;
            const Vec3 c = H.transpose() * point.force;
            for (std::size_t n = 0; n < nodes.size(); ++n) {
              out[nodes[n]][k] -= N[static_cast<Eigen::Index>(n)] * c;
            }
          }
        }
      }
    });
  }
}

void add_partner_tractions(const FrontSetting& set, const FrontFields& fields,
                           const base::Vector& u, FrontForces& out) {
  for (const FrontSide& side : fields.sides) {
    fe::with_side(set.mesh, side.face, [&]<shape::Shape Side>(Side) {
      if constexpr (Side::dim == 2) {
        const fe::SideNodes<Side> X = fe::side_coordinates<Side>(set.mesh, side.face);
        const auto nodes = fe::nodes_of_face<Side>(set.mesh, side.face);
        const fe::SideNodes<Side> U = displacements<Side>(nodes, u);
        for (const auto& point : shape::quadrature<Side>(front_degree)) {
          const Eigen::Matrix<double, Side::nodes, 1> N = Side::N(point.r);
          const FrontPlace place = set.axes.place(X * N, side.on);
          const Vec3 area = point.weight * fe::area_vector<Side>(X, point.r);
          const Tensor<3> H = U * surface_gradients<Side>(X, point.r);
          for (std::size_t k = 1; k < front_partners; ++k) {
            const Vec3 c = H.transpose() * (moving_field(k, place, set.body).sigma * area);
            for (std::size_t n = 0; n < nodes.size(); ++n) {
              out[nodes[n]][k] -= N[static_cast<Eigen::Index>(n)] * c;
            }
          }
        }
      }
    });
  }
}

} // namespace spricka::crack
