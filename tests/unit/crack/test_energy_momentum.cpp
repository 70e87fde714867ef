// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/auxiliary_field.hpp"

#include <gtest/gtest.h>

#include <cmath>

// The energy of an element whose nodes keep their displacements while they move, by central
// differences, against the nodal forces of the energy-momentum: in the plane and in space.
namespace spricka::crack::test_energy_momentum {
namespace {

template <int dim> fe::Elasticity<dim> steel() {
  model::ElasticMaterial material;
  material.E = 210.0;
  material.nu = 0.3;
  return fe::elasticity<dim>(material, dim == 3 ? model::StressState::solid
                                                : model::StressState::plane_strain);
}

/// Nodal values without a pattern, a reproducible part of one.
template <int dim> fe::AnyNodeVectors<dim> rough(const fe::AnyElement<dim>& element, double seed) {
  fe::AnyNodeVectors<dim> V(dim, element.nodes);
  for (Eigen::Index i = 0; i < V.size(); ++i) {
    V(i) = std::sin(seed + 1.7 * static_cast<double>(i * i));
  }
  return V;
}

/// The reference element with its nodes pushed about.
template <int dim> fe::AnyNodeVectors<dim> skewed(const fe::AnyElement<dim>& element) {
  fe::AnyNodeVectors<dim> X = 0.04 * rough(element, 0.3);
  for (int i = 0; i < element.nodes; ++i) {
    X.col(i) += element.node_local_coordinates(i);
  }
  return X;
}

constexpr int degree = 8;

/// Sum over nodes of what their motion V releases.
template <int dim>
double released(const fe::AnyElement<dim>& element, const fe::AnyNodeVectors<dim>& X,
                const fe::AnyNodeVectors<dim>& U, const fe::AnyNodeVectors<dim>& V) {
  double sum = 0.0;
  for (const auto& point : shape::quadrature<dim>(element.domain, degree)) {
    const auto at = fe::jacobian(element, X, point.r);
    const Tensor<dim> H = U.lazyProduct(at.dNdx);
    const Tensor<dim> sigma = stress_from_gradient<dim>(steel<dim>(), H);
    const Tensor<dim> T = energy_momentum<dim>({H, sigma});
    sum += point.weight * at.det * T.cwiseProduct(Tensor<dim>(V.lazyProduct(at.dNdx))).sum();
  }
  return sum;
}

template <int dim>
double energy(const fe::AnyElement<dim>& element, const fe::AnyNodeVectors<dim>& X,
              const fe::AnyNodeVectors<dim>& U) {
  double sum = 0.0;
  for (const auto& point : shape::quadrature<dim>(element.domain, degree)) {
    const auto at = fe::jacobian(element, X, point.r);
    const Tensor<dim> H = U.lazyProduct(at.dNdx);
    sum += 0.5 * point.weight * at.det *
           stress_from_gradient<dim>(steel<dim>(), H).cwiseProduct(H).sum();
  }
  return sum;
}

template <class S> class EnergyMomentum : public testing::Test {};
using Shapes = testing::Types<shape::Trimc6, shape::Quamc8, shape::Tet10, shape::Pentac15,
                              shape::Hexec20, shape::Hexec27>;
TYPED_TEST_SUITE(EnergyMomentum, Shapes);

TYPED_TEST(EnergyMomentum, IsWhatMovingNodesRelease) {
  const auto& element = shape::as_reference_element<TypeParam>();
  using Vectors = fe::AnyNodeVectors<TypeParam::dim>;
  const Vectors X = skewed(element);
  const Vectors U = rough(element, 1.1);
  const Vectors V = rough(element, 2.9);
  const double h = 1e-5;
  const Vectors ahead = X + h * V;
  const Vectors back = X - h * V;
  const double slope = (energy(element, ahead, U) - energy(element, back, U)) / (2.0 * h);
  EXPECT_NEAR(released(element, X, U, V), -slope, 1e-7 * std::abs(energy(element, X, U)));
}

// Two displacements: the release of their sum less those of each.
TYPED_TEST(EnergyMomentum, OfTwoIsTheBilinearForm) {
  constexpr int dim = TypeParam::dim;
  const auto& element = shape::as_reference_element<TypeParam>();
  const Tensor<dim> Hu = rough(element, 0.2).template leftCols<dim>();
  const Tensor<dim> Hv = rough(element, 0.7).template leftCols<dim>();
  const Tensor<dim> H = Hu + Hv;
  const Tensor<dim> su = stress_from_gradient<dim>(steel<dim>(), Hu);
  const Tensor<dim> sv = stress_from_gradient<dim>(steel<dim>(), Hv);
  const Tensor<dim> s = su + sv;
  AuxiliaryFields<dim> fields;
  AuxiliaryField<dim> none;
  none.H.setZero();
  for (std::size_t k = 1; k < auxiliary_field_count<dim>; ++k) {
    fields.set(k, none);
  }
  AuxiliaryField<dim> v;
  v.H = Hv;
  v.sigma = sv;
  fields.set(2, v);
  GradientStressState<dim> u;
  u.H = Hu;
  u.sigma = su;
  const TensorOfFields<dim> T =
      interaction_energy_momentum<dim>(u, fields, work_densities<dim>(u, fields));
  Tensor<dim> both;
  for (std::size_t j = 0; j < dim; ++j) {
    for (std::size_t i = 0; i < dim; ++i) {
      both(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = T[j][i][1];
      EXPECT_EQ(T[j][i][0], 0.0);
    }
  }
  const Tensor<dim> rest = energy_momentum<dim>({H, s}) - energy_momentum<dim>({Hu, su}) -
                           energy_momentum<dim>({Hv, sv});
  EXPECT_LT((both - rest).norm(), 1e-12 * both.norm());
}

} // namespace
} // namespace spricka::crack::test_energy_momentum
