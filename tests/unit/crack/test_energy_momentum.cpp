// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/energy_momentum.hpp"

#include <gtest/gtest.h>

#include <cmath>

// The energy of an element whose nodes keep their displacements while they move, by central
// differences, against the nodal forces of the energy-momentum: in the plane and in space.
namespace spricka::crack {
namespace {

template <shape::ElementShape S> fe::Elasticity<S::dim> steel() {
  model::Material material;
  material.E = 210.0;
  material.nu = 0.3;
  return fe::elasticity<S::dim>(material,
                                S::dim == 3 ? model::State::solid : model::State::plane_strain);
}

/// Nodal values without a pattern, a reproducible part of one.
template <shape::ElementShape S> fe::NodeVectors<S> rough(double seed) {
  fe::NodeVectors<S> V;
  for (Eigen::Index i = 0; i < V.size(); ++i) {
    V(i) = std::sin(seed + 1.7 * static_cast<double>(i * i));
  }
  return V;
}

/// The reference element with its nodes pushed about.
template <shape::ElementShape S> fe::NodeVectors<S> skewed() {
  fe::NodeVectors<S> X;
  for (int i = 0; i < S::nodes; ++i) {
    X.col(i) = shape::node<S>(i);
  }
  return X + 0.04 * rough<S>(0.3);
}

constexpr int degree = 8;

/// Sum over nodes of what their motion V releases.
template <shape::ElementShape S>
double released(const fe::NodeVectors<S>& X, const fe::NodeVectors<S>& U,
                const fe::NodeVectors<S>& V) {
  double sum = 0.0;
  for (const auto& point : shape::quadrature<S>(degree)) {
    const fe::Jacobian<S> at = fe::jacobian<S>(X, point.r);
    const Tensor<S::dim> H = U * at.dNdx;
    const Tensor<S::dim> sigma = stress_of<S::dim>(steel<S>(), H);
    const Tensor<S::dim> T = energy_momentum<S::dim>({H, sigma});
    sum += point.weight * at.det * T.cwiseProduct(Tensor<S::dim>(V * at.dNdx)).sum();
  }
  return sum;
}

template <shape::ElementShape S>
double energy(const fe::NodeVectors<S>& X, const fe::NodeVectors<S>& U) {
  double sum = 0.0;
  for (const auto& point : shape::quadrature<S>(degree)) {
    const fe::Jacobian<S> at = fe::jacobian<S>(X, point.r);
    const Tensor<S::dim> H = U * at.dNdx;
    sum += 0.5 * point.weight * at.det * stress_of<S::dim>(steel<S>(), H).cwiseProduct(H).sum();
  }
  return sum;
}

template <class S> class EnergyMomentum : public testing::Test {};
using Shapes = testing::Types<shape::Trimc6, shape::Quamc8, shape::Tet10, shape::Pentac15,
                              shape::Hexec20, shape::Hexec27>;
TYPED_TEST_SUITE(EnergyMomentum, Shapes);

TYPED_TEST(EnergyMomentum, IsWhatMovingNodesRelease) {
  using S = TypeParam;
  const fe::NodeVectors<S> X = skewed<S>();
  const fe::NodeVectors<S> U = rough<S>(1.1);
  const fe::NodeVectors<S> V = rough<S>(2.9);
  const double h = 1e-5;
  const fe::NodeVectors<S> ahead = X + h * V;
  const fe::NodeVectors<S> back = X - h * V;
  const double slope = (energy<S>(ahead, U) - energy<S>(back, U)) / (2.0 * h);
  EXPECT_NEAR(released<S>(X, U, V), -slope, 1e-7 * std::abs(energy<S>(X, U)));
}

// Two displacements: the release of their sum less those of each.
TYPED_TEST(EnergyMomentum, OfTwoIsTheBilinearForm) {
  constexpr int dim = TypeParam::dim;
  const Tensor<dim> Hu = rough<TypeParam>(0.2).template leftCols<dim>();
  const Tensor<dim> Hv = rough<TypeParam>(0.7).template leftCols<dim>();
  const Tensor<dim> H = Hu + Hv;
  const Tensor<dim> su = stress_of<dim>(steel<TypeParam>(), Hu);
  const Tensor<dim> sv = stress_of<dim>(steel<TypeParam>(), Hv);
  const Tensor<dim> s = su + sv;
  const Tensor<dim> both = energy_momentum<dim>({Hu, su}, {Hv, sv});
  const Tensor<dim> rest = energy_momentum<dim>({H, s}) - energy_momentum<dim>({Hu, su}) -
                           energy_momentum<dim>({Hv, sv});
  EXPECT_LT((both - rest).norm(), 1e-12 * both.norm());
}

} // namespace
} // namespace spricka::crack
