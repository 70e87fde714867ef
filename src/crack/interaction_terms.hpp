// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/configurational_forces.hpp"
#include "crack/front_loads.hpp"
#include "model/mesh_side.hpp"

#include <optional>

/// Terms of G, K and T on faces, in the plane and in space. Their `Source` is TipAuxiliaryFields or
/// FrontAuxiliaryFields: what the domains of a front are and which auxiliary fields act in them.
namespace spricka::crack {

/// Displacements of the nodes of a side. [dim, node]
template <int dim>
using SideVectors = Eigen::Matrix<double, dim, Eigen::Dynamic, 0, dim, shape::most_nodes<2>>;
/// Those of a side from all of the mesh, u [dim * node].
template <int dim>
SideVectors<dim> side_displacements(const geometry::ElementSide& side, const base::Vector& u) {
  SideVectors<dim> U(dim, side.X.cols());
  for (std::size_t i = 0; i < side.nodes.size(); ++i) {
    U.col(static_cast<Eigen::Index>(i)) =
        u.template segment<dim>(dim * static_cast<Eigen::Index>(side.nodes[i].index()));
  }
  return U;
}

/// Derivatives of the functions of a side along it as gradients. [node, dim]
template <int dim>
using SurfaceGradients = Eigen::Matrix<double, Eigen::Dynamic, dim, 0, shape::most_nodes<2>, dim>;
/// Gradients of a side's shape functions at a reference point, tangent to the side [1/length].
template <int dim>
SurfaceGradients<dim> surface_gradients(const geometry::ElementSide& side, const base::Vec2& r) {
  const geometry::SideTangents slope = side.tangents(r);
  const Eigen::Matrix2d metric = slope.transpose() * slope;
  const Eigen::Matrix<double, 2, 3> back = metric.inverse() * slope.transpose();
  return side.dN(r).lazyProduct(back.leftCols<dim>());
}

/// - N_n c of each node, to what an auxiliary field releases.
template <int dim>
void subtract_configurational_forces(const geometry::ElementSide& side,
                                     const geometry::SideValues& N, std::size_t auxiliary,
                                     const shape::Point<dim>& c,
                                     InteractionConfigurationalForces<dim>& out) {
  for (std::size_t n = 0; n < side.nodes.size(); ++n) {
    out[side.nodes[n]][auxiliary] -= N[static_cast<Eigen::Index>(n)] * c;
  }
}

/// Work of forces on sides in the field that the extension carries along, - t_i u_i,k N_n, and the
/// same of the auxiliary fields (crack.20, crack_space.9). It needs no gradient of the element,
/// which a quarter-point element has none of at the front. Forces on sides that no domain moves add
/// nothing.
template <class Source>
void add_face_load_terms(const Source& source, const std::vector<FacePointForces>& forces,
                         const base::Vector& u,
                         InteractionConfigurationalForces<Source::dim>& out) {
  constexpr int dim = Source::dim;
  for (const FacePointForces& on : forces) {
    const std::optional<UpperOrLowerFace> known = source.crack_face_of_element_side(on.face);
    if (!known) {
      continue;
    }
    const geometry::ElementSide side = model::element_side(source.context().mesh, on.face);
    const SideVectors<dim> U = side_displacements<dim>(side, u);
    for (const fe::LoadPoint& point : on.points) {
      const base::Vec2 r = point.r.head<2>();
      const std::optional<typename Source::Place> place = source.locate_on_side(side, r, *known);
      if (!place) {
        continue; // the front itself, without an area
      }
      const geometry::SideValues N = side.N(r);
      const shape::Point<dim> x = (side.X * N).template head<dim>();
      const shape::Point<dim> force =
          source.context().relative_depth(x) * point.force.template head<dim>();
      for (std::size_t k = 0; k < auxiliary_field_count<dim>; ++k) {
        const Tensor<dim> H = k == 0 ? Tensor<dim>(U.lazyProduct(surface_gradients<dim>(side, r)))
                                     : source.auxiliary_side_gradient(*place, k);
        subtract_configurational_forces<dim>(side, N, k, H.transpose() * force, out);
      }
    }
  }
}

/// Of the auxiliary fields' own tractions on free sides, - t_aux_i u_i,k N_n: those of a front that
/// turns and of fields carried round an axis are not zero on the crack's faces, and those of a
/// plane strain are not where the front leaves the body (crack.40, crack_space.8).
template <class Source>
void add_auxiliary_tractions(const Source& source, const base::Vector& u,
                             InteractionConfigurationalForces<Source::dim>& out) {
  constexpr int dim = Source::dim;
  for (const MovedFreeSide& moved : source.moved_free_sides()) {
    const geometry::ElementSide side = model::element_side(source.context().mesh, moved.face);
    const SideVectors<dim> U = side_displacements<dim>(side, u);
    for (const auto& point : source.side_quadrature(side)) {
      const std::optional<typename Source::Place> place =
          source.locate_on_side(side, point.r, moved.on);
      if (!place) {
        continue;
      }
      const geometry::SideValues N = side.N(point.r);
      const shape::Point<dim> x = (side.X * N).template head<dim>();
      const shape::Point<dim> area = (point.weight * source.context().relative_depth(x)) *
                                     side.area_vector(point.r).template head<dim>();
      const Tensor<dim> H = U.lazyProduct(surface_gradients<dim>(side, point.r));
      for (std::size_t k = 1; k < auxiliary_field_count<dim>; ++k) {
        subtract_configurational_forces<dim>(
            side, N, k, H.transpose() * source.auxiliary_traction(*place, k, area), out);
      }
    }
  }
}

} // namespace spricka::crack
