// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outer_products.hpp"
#include "crack/configurational_forces.hpp"
#include "crack/load_fields.hpp"
#include "fe/jacobian.hpp"

#include <array>
#include <utility>
#include <vector>

/// The integral over the domains of a front, in the plane and in space.
namespace spricka::crack {

/// The solution at a point of an element, its stress with what the temperature takes out.
template <int dim> struct ThermoelasticState : GradientStressState<dim> {
  Tensor<dim> nodal = Tensor<dim>::Zero();    ///< gradient of the nodes' displacement
  Tensor<dim> strained = Tensor<dim>::Zero(); ///< gradient that has this stress
  double beta_T = 0.0;                        ///< stress that the temperature takes out
  shape::Point<dim> beta_grad_T = shape::Point<dim>::Zero(); ///< and its gradient
  double heated_dilatation = 0.0; ///< volume change that a temperature works on in G
};

/// Energy-momentum at a point, in the section and round an axis.
template <int dim> struct AxisymmetricEnergyMomentum {
  Tensor<dim> T = Tensor<dim>::Zero();
  double hoop = 0.0;
};

/// One element of the domains: energy-momentum (crack.4, crack.10, crack_space.6), forces per
/// volume (crack.19), the temperature's gradient (crack.22, crack.23) and the divergence of the
/// auxiliary fields' stress (crack.39, crack_space.8). `Source` is TipAuxiliaryFields or
/// FrontAuxiliaryFields; `ElementHeat` says what the temperature does in the element:
///   heat(at, r, x, here)     sets what ThermoelasticState has of it, and H where nodes are
///   carried; cool(here, beta_T)       takes normal stresses out; met(own, x)              what
///   auxiliary fields meet in the solution's place; is_carried(), expansion_gradient(x)   nodes
///   that a free expansion carries.
template <class Source, class ElementHeat> class ElementConfigurationalForces {
public:
  static constexpr int dim = Source::dim;

  ElementConfigurationalForces(const Source& source, const ElementHeat& heat,
                               const std::vector<BodyForceField>& body, base::ElementId e,
                               const base::Vector& u)
      : source_(source), heat_(heat), body_(body), e_(e),
        element_(shape::reference_element<dim>(mesh().type[e.index()])),
        X_(fe::element_coordinates(element_, mesh(), e)),
        U_(fe::gather_element_values(element_, mesh(), e, u)), elasticity_(source.elasticity(e)) {}

  /// Adds all terms; `strained`: the extension is not constant in the element.
  void add_element_terms(bool strained, InteractionConfigurationalForces<dim>& out) const {
    OfNodes P = OfNodes::Zero(rows, element_.nodes);
    std::size_t number = 0;
    for (const auto& point : source_.element_quadrature(e_)) {
      add_point(point, number++, strained, P);
    }
    add_body_forces(P);
    Eigen::Index i = 0;
    for (const base::NodeId n : mesh().element_nodes(e_)) {
      typename InteractionConfigurationalForces<dim>::OfNode& sum = out[n];
      for (std::size_t k = 0; k < sum.size(); ++k) {
        for (Eigen::Index c = 0; c < dim; ++c) {
          sum[k][c] += P(row(k, c), i);
        }
      }
      ++i;
    }
  }

private:
  /// Components of vectors: those of the solution with itself, and each component with all
  /// auxiliary fields side by side; both and all together fill whole registers.
  static constexpr Eigen::Index fields = OfFields<dim>::SizeAtCompileTime;
  static constexpr Eigen::Index own_rows = (dim + 1) / 2 * 2;
  static constexpr Eigen::Index rows = (own_rows + dim * fields + 3) / 4 * 4;
  static Eigen::Index row(std::size_t k, Eigen::Index component) {
    return k == 0 ? component : own_rows + fields * component + static_cast<Eigen::Index>(k) - 1;
  }
  /// [row, node]
  using OfNodes = Eigen::Matrix<double, rows, Eigen::Dynamic, 0, rows, shape::most_nodes<dim>>;
  /// The gradients of the shape functions, and these themselves. [node, dim + 1]
  using GradientsAndFunctions =
      Eigen::Matrix<double, Eigen::Dynamic, dim + 1, 0, shape::most_nodes<dim>, dim + 1>;
  using Vector = shape::Point<dim>;

  [[nodiscard]] const model::Mesh& mesh() const { return source_.context().mesh; }

  void add_point(const shape::QuadraturePoint<dim>& point, std::size_t number, bool strained,
                 OfNodes& P) const {
    const shape::ShapeFunctionValues<dim>& functions = source_.shape_functions(e_, number, point.r);
    const fe::Jacobian<fe::AnyElement<dim>> at =
        fe::jacobian_by_derivatives<fe::AnyElement<dim>>(X_, functions.dN);
    const fe::NodeValues<fe::AnyElement<dim>>& N = functions.N;
    const Vector x = X_ * N;
    const double weight = point.weight * at.det * source_.context().relative_depth(x);
    const ThermoelasticState<dim> own = solution(at, point.r, N, x);
    // Auxiliary fields may meet another temperature than G (crack.34).
    const ThermoelasticState<dim>& met = heat_.met(own, x);
    // T by column, and c, what N_n itself is multiplied with.
    Eigen::Matrix<double, rows, dim + 1> terms = Eigen::Matrix<double, rows, dim + 1>::Zero();
    const AxisymmetricEnergyMomentum<dim> M = own_momentum(own);
    if (strained) {
      terms.template topLeftCorner<dim, dim>() = M.T;
    }
    // About an axis the way outwards (crack.37).
    terms.template topRightCorner<dim, 1>() =
        own.heated_dilatation * own.beta_grad_T + source_.context().hoop_body_force(M.hoop, x);
    set_interaction_terms(met, source_.auxiliary_fields(e_, number, x, elasticity_), x, strained,
                          terms);
    GradientsAndFunctions by_node(element_.nodes, dim + 1);
    by_node << at.dNdx, N;
    base::add_outer_products(weight, terms, by_node, P);
    for (int n = 0; n < element_.nodes && heat_.is_carried(); ++n) {
      // Nodes carried through the free expansion, in G.
      const Vector gradient = at.dNdx.row(n).transpose();
      P.col(n).template head<dim>() +=
          weight * (heat_.expansion_gradient(X_.col(n)).transpose() * (own.sigma * gradient));
    }
  }

  [[nodiscard]] ThermoelasticState<dim> solution(const fe::Jacobian<fe::AnyElement<dim>>& at,
                                                 const shape::Point<dim>& r,
                                                 const fe::NodeValues<fe::AnyElement<dim>>& N,
                                                 const Vector& x) const {
    ThermoelasticState<dim> here;
    here.nodal = here.H = here.strained = U_.lazyProduct(at.dNdx);
    here.hoop = source_.context().hoop_strain(U_ * N, x);
    here.heated_dilatation = here.dilatation();
    heat_.heat(at, r, x, here);
    static_cast<GradientStressState<dim>&>(here) =
        elasticity_.state_from_gradient(here.H, here.hoop);
    heat_.cool(here, here.beta_T);
    return here;
  }

  // Of u with itself, halved: W is half of (sigma - beta T) : eps.
  static AxisymmetricEnergyMomentum<dim> own_momentum(const ThermoelasticState<dim>& u) {
    const double thermal = u.beta_T * u.heated_dilatation;
    const double round = u.sigma_hoop * u.hoop;
    return {energy_momentum<dim>({u.strained, u.sigma}, thermal - round),
            round - 0.5 * (u.sigma.cwiseProduct(u.strained).sum() + round - thermal)};
  }

  // The same of the solution and the auxiliary fields (crack.10), by column, and what N_n itself is
  // multiplied with.
  void set_interaction_terms(const ThermoelasticState<dim>& u, const AuxiliaryFields<dim>& v,
                             const Vector& x, bool strained,
                             Eigen::Matrix<double, rows, dim + 1>& terms) const {
    const OfFields<dim> work = work_densities<dim>(u, v);
    if (strained) {
      const TensorOfFields<dim> T = interaction_energy_momentum<dim>(u, v, work);
      for (Eigen::Index j = 0; j < dim; ++j) {
        for (Eigen::Index i = 0; i < dim; ++i) {
          terms.template block<fields, 1>(row(1, i), j) =
              T[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)].matrix();
        }
      }
    }
    OfFields<dim> dilatation = v.hoop;
    for (std::size_t i = 0; i < dim; ++i) {
      dilatation += v.H[i][i];
    }
    const OfFields<dim> hoop = u.sigma_hoop * v.hoop + u.hoop * v.sigma_hoop - work;
    for (Eigen::Index i = 0; i < dim; ++i) {
      OfFields<dim> c = u.beta_grad_T[i] * dilatation;
      for (Eigen::Index m = 0; m < dim; ++m) {
        c += u.nodal(m, i) * v.divergence[static_cast<std::size_t>(m)];
      }
      for (Eigen::Index k = 0; k < fields; ++k) { // about an axis the way outwards (crack.37)
        c[k] += source_.context().hoop_body_force(hoop[k], x)[i];
      }
      terms.template block<fields, 1>(row(1, i), dim) = c.matrix();
    }
  }

  // - q b . u,k (crack.19) and the same of the auxiliary fields (crack.23), at points of the load's
  // own: it may bend and jump where the fields do not.
  void add_body_forces(OfNodes& P) const {
    const auto add = [&](const shape::Point<dim>& r, double weight, const Vector& b) {
      const fe::Jacobian<fe::AnyElement<dim>> at = fe::jacobian(element_, X_, r);
      const fe::NodeValues<fe::AnyElement<dim>> N = element_.N(r);
      const Vector x = X_ * N;
      const typename Source::Place place = source_.locate_in_element(x);
      for (std::size_t k = 0; k < auxiliary_field_count<dim>; ++k) {
        const Tensor<dim> H =
            k == 0 ? Tensor<dim>(U_.lazyProduct(at.dNdx)) : source_.auxiliary_gradient(place, k);
        const Vector c =
            weight * at.det * source_.context().relative_depth(x) * (H.transpose() * b);
        for (int n = 0; n < element_.nodes; ++n) {
          for (Eigen::Index i = 0; i < dim; ++i) {
            P(row(k, i), n) -= N[n] * c[i];
          }
        }
      }
    };
    visit_body_force_points<dim>(mesh(), body_, e_, X_, add);
  }

  const Source& source_;
  const ElementHeat& heat_;
  const std::vector<BodyForceField>& body_;
  base::ElementId e_;
  const fe::AnyElement<dim>& element_;
  fe::AnyNodeVectors<dim> X_;
  fe::AnyNodeVectors<dim> U_;
  decltype(std::declval<const Source&>().elasticity(base::ElementId())) elasticity_;
};

} // namespace spricka::crack
