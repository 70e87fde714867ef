// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/space/face_forces.hpp"

#include "crack/space/front_rule.hpp"
#include "model/mesh_side.hpp"
#include "shape/quadrature.hpp"

#include <map>

namespace spricka::crack {

using base::Vec3;

namespace {

fe::SpaceNodes<2> displacements(const geometry::ElementSide& side, const base::Vector& u) {
  fe::SpaceNodes<2> U(3, side.X.cols());
  for (std::size_t i = 0; i < side.nodes.size(); ++i) {
    U.col(static_cast<Eigen::Index>(i)) =
        u.segment<3>(3 * static_cast<Eigen::Index>(side.nodes[i].index()));
  }
  return U;
}

// - N_n c of each node, to what a auxiliary field releases.
void subtract_at_nodes(const geometry::ElementSide& side, const fe::AnyElement<2>::Values& N,
                       std::size_t auxiliary, const Vec3& c, FrontConfigurationalForces& out) {
  for (std::size_t n = 0; n < side.nodes.size(); ++n) {
    out[side.nodes[n]][auxiliary] -= N[static_cast<Eigen::Index>(n)] * c;
  }
}

} // namespace

SurfaceGradients surface_gradients(const geometry::ElementSide& side, const shape::Point<2>& r) {
  const fe::AnyElement<2>::SplineDerivatives dN = side.dN(r);
  const Eigen::Matrix<double, 3, 2> slope = side.X.lazyProduct(dN);
  const Eigen::Matrix2d metric = slope.transpose() * slope;
  const Eigen::Matrix<double, 2, 3> back = metric.inverse() * slope.transpose();
  return dN.lazyProduct(back);
}

void add_face_forces(const FrontSetting& set, const FrontExtensions& fields,
                     const std::vector<FacePointForces>& forces, const base::Vector& u,
                     FrontConfigurationalForces& out) {
  std::map<model::Face, CrackFaceSide> moved;
  for (const MovedFreeSide& side : fields.sides) {
    moved.emplace(side.face, side.on);
  }
  for (const FacePointForces& on : forces) {
    const auto known = moved.find(on.face);
    if (known == moved.end()) {
      continue;
    }
    const geometry::ElementSide side = model::element_side(set.mesh, on.face);
    const fe::SpaceNodes<2> U = displacements(side, u);
    for (const fe::LoadPoint& point : on.points) {
      const shape::Point<2> r = point.r.head<2>();
      const fe::AnyElement<2>::Values N = side.N(r);
      const FrontCoordinates place = set.axes.locate_point(side.X * N, known->second);
      if (!(place.r > 0.0)) {
        continue; // the front itself, a line without an area
      }
      const TurningAxes axes(place);
      for (std::size_t k = 0; k < front_auxiliary_field_count; ++k) {
        const Tensor<3> H = k == 0 ? Tensor<3>(U.lazyProduct(surface_gradients(side, r)))
                                   : front_auxiliary_field(k, axes, set.body).H;
        subtract_at_nodes(side, N, k, H.transpose() * point.force, out);
      }
    }
  }
}

void add_auxiliary_tractions(const FrontSetting& set, const FrontExtensions& fields,
                             const base::Vector& u, FrontConfigurationalForces& out) {
  for (const MovedFreeSide& moved : fields.sides) {
    const geometry::ElementSide side = model::element_side(set.mesh, moved.face);
    const fe::SpaceNodes<2> U = displacements(side, u);
    for (const auto& point : shape::quadrature<2>(side.domain(), front_degree)) {
      const fe::AnyElement<2>::Values N = side.N(point.r);
      const TurningAxes axes(set.axes.locate_point(side.X * N, moved.on));
      const Vec3 area = point.weight * side.area_vector(point.r);
      const Tensor<3> H = U.lazyProduct(surface_gradients(side, point.r));
      for (std::size_t k = 1; k < front_auxiliary_field_count; ++k) {
        subtract_at_nodes(side, N, k,
                          H.transpose() * (front_auxiliary_field(k, axes, set.body).sigma * area),
                          out);
      }
    }
  }
}

} // namespace spricka::crack
