// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/assemble.hpp"
#include "fe/element.hpp"
#include "fe/stress.hpp"
#include "fe/thermal.hpp"
#include "model/model.hpp"
#include "tests/unit/fe/field.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// Single elements in space and about an axis: K02 (rigid modes and no other), volume, equilibrium
// of a temperature, projected dilatation.
namespace spricka::fe::test_solid_elements {
namespace {

using base::Vec3;

model::Model one_property(double E, double nu, model::StressState state) {
  model::Model model;
  model::ElasticMaterial material;
  material.E = E;
  material.nu = nu;
  material.alpha = 1e-5;
  model.materials.push_back(material);
  model::ElementProperty property;
  property.material = base::MaterialId(0);
  property.state = state;
  model.properties.push_back(property);
  return model;
}

// The reference element, stretched, twisted and (if quadratic) with mid nodes off their middles.
template <class S> NodeVectors<S> distorted() {
  NodeVectors<S> X;
  for (int i = 0; i < S::nodes; ++i) {
    const shape::Point<S::dim> r = shape::node_local_coordinates<S>(i);
    X.col(i) = 1.3 * r;
    X(0, i) += 4.0 + 0.2 * r[0] * r[1] + 0.1 * r[S::dim - 1];
    X(1, i) += 0.15 * r[0] * r[S::dim - 1] - 0.3 * r[0];
    if (i >= base::element_info(S::type).corners) {
      X(i % S::dim, i) += 0.02 * std::sin(7.0 * i);
    }
  }
  return X;
}

template <class S> model::Model one_element(double nu, model::StressState state) {
  model::Model model = one_property(1000.0, nu, state);
  model.mesh.dim = S::dim;
  std::vector<base::NodeId> nodes;
  const NodeVectors<S> X = distorted<S>();
  for (int i = 0; i < S::nodes; ++i) {
    Vec3 x = Vec3::Zero();
    x.template head<S::dim>() = X.col(i);
    nodes.push_back(model::add_node(model.mesh, x, i + 1, base::NetId(0)));
  }
  model::add_element(model.mesh, S::type, nodes, 1, base::NetId(0));
  model.mesh.property[0] = base::PropertyId(0);
  model.mesh.element_sets.push_back({"ALL", {base::ElementId(0)}, {}});
  return model;
}

int zero_eigenvalues(const base::Matrix& K) {
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues();
  const double largest = values[values.size() - 1];
  return static_cast<int>((values.array().abs() < 1e-10 * largest).count());
}

template <class S> class EverySolid : public testing::Test {};
using Solids = testing::Types<shape::Tet4, shape::Tet10, shape::Penta6, shape::Pentac15,
                              shape::Hexe8, shape::Hexec20, shape::Hexec27>;
TYPED_TEST_SUITE(EverySolid, Solids);

TYPED_TEST(EverySolid, has_six_rigid_modes_and_no_other_zero) {
  using S = TypeParam;
  for (const double nu : {0.3, 0.4999}) {
    const model::Model model = one_property(1000.0, nu, model::StressState::solid);
    const ConstitutiveLaw law = constitutive_law(model.materials[0], model.properties[0], S::type);
    EXPECT_EQ(law.projected, nu > (base::element_info(S::type).quadratic ? 0.49 : 0.4));
    EXPECT_EQ(zero_eigenvalues(element_stiffness<S>(distorted<S>(), law)), 6) << nu;
  }
}

TYPED_TEST(EverySolid, force_is_stiffness_times_displacement) {
  using S = TypeParam;
  for (const double nu : {0.3, 0.499}) {
    const model::Model model = one_property(1000.0, nu, model::StressState::solid);
    const ConstitutiveLaw law = constitutive_law(model.materials[0], model.properties[0], S::type);
    NodeVectors<S> U;
    for (int i = 0; i < U.size(); ++i) {
      U(i) = std::sin(1.0 + 2.0 * i);
    }
    const base::Matrix Ke = element_stiffness<S>(distorted<S>(), law);
    const base::Vector f = Ke * base::Vector(U.reshaped());
    EXPECT_LT((element_force<S>(distorted<S>(), law, U).reshaped() - f).norm(), 1e-12 * f.norm());
  }
}

// Free and heated by the linear field T = c.x: u is quadratic and known, and no stress is left
// where the element can follow (straight sides are needed, so the affine image is taken).
template <class S> void expect_free_expansion(model::StressState state) {
  model::Model model = one_element<S>(0.3, state);
  for (std::size_t n = 0; n < model.mesh.node_count(); ++n) {
    Vec3 x = Vec3::Zero();
    const shape::Point<S::dim> r = shape::node_local_coordinates<S>(static_cast<int>(n));
    x.template head<S::dim>() = r;
    model.mesh.x[n] = Vec3(2.0 * x.x() + 0.3 * x.y(), x.y() - 0.4 * x.x() + 0.2 * x.z(),
                           1.5 * x.z() + (S::dim == 3 ? 0.1 * x.y() : 0.0));
  }
  model::LoadCase heat;
  model::Load load;
  load.type = model::LoadType::temperature;
  load.elements = base::ElementSetId(0);
  const Vec3 c = S::dim == 3 ? Vec3(3.0, -2.0, 1.0) : Vec3(3.0, -2.0, 0.0);
  const test::CardField z{base::OpCode::z};
  load.value = {(test::CardField(c.x()) * test::x_field + test::CardField(c.y()) * test::y_field +
                 test::CardField(c.z()) * z + test::CardField(5.0))
                    .code};
  heat.loads.push_back(load);
  const base::Vector T = corner_temperatures_of_case(model, model.mesh, heat);
  // eps = alpha T I: u_i = alpha (T x_i - c_i |x|^2 / 2) with T = 5 + c.x.
  base::Vector u(S::dim * S::nodes);
  for (int n = 0; n < S::nodes; ++n) {
    const Vec3 x = model.mesh.x[static_cast<std::size_t>(n)];
    const Vec3 v = 1e-5 * ((5.0 + c.dot(x)) * x - 0.5 * x.squaredNorm() * c);
    u.template segment<S::dim>(S::dim * n) = v.template head<S::dim>();
  }
  const double scale = 1000.0 * 1e-5 * 10.0;
  for (const Stress& s : element_node_stress(model, model.mesh, {u, T})) {
    EXPECT_LT(s.cwiseAbs().maxCoeff(), 1e-11 * scale);
  }
  base::Vector internal = base::Vector::Zero(u.size());
  const std::vector<base::ElementId> all{base::ElementId(0)};
  add_internal_force(model, model.mesh, all, u, internal);
  const base::Vector f = thermal_load(model, model.mesh, T);
  EXPECT_LT((internal - f).lpNorm<Eigen::Infinity>(), 1e-12 * f.lpNorm<Eigen::Infinity>());
  // no stress, no energy: 1/2 u K u - u f + 1/2 eps D eps = 0
  const double strain_energy = 0.5 * internal.dot(u);
  std::vector<double> energy{strain_energy};
  add_thermal_energy(model, model.mesh, T, u, energy);
  EXPECT_NEAR(energy.front(), 0.0, 1e-12 * strain_energy);
}

TEST(ThermalStrain, linear_temperature_leaves_quadratic_elements_without_stress) {
  expect_free_expansion<shape::Trimc6>(model::StressState::plane_stress);
  expect_free_expansion<shape::Quamc8>(model::StressState::plane_stress);
  expect_free_expansion<shape::Quamc9>(model::StressState::plane_stress);
  expect_free_expansion<shape::Tet10>(model::StressState::solid);
  expect_free_expansion<shape::Pentac15>(model::StressState::solid);
  expect_free_expansion<shape::Hexec20>(model::StressState::solid);
  expect_free_expansion<shape::Hexec27>(model::StressState::solid);
}

template <class S> class EveryRing : public testing::Test {};
using Rings =
    testing::Types<shape::Trim3, shape::Trimc6, shape::Quam4, shape::Quamc8, shape::Quamc9>;
TYPED_TEST_SUITE(EveryRing, Rings);

TYPED_TEST(EveryRing, moves_freely_along_the_axis_only) {
  using S = TypeParam;
  for (const double nu : {0.3, 0.4999}) {
    const model::Model model = one_property(1000.0, nu, model::StressState::axisymmetric);
    const ConstitutiveLaw law = constitutive_law(model.materials[0], model.properties[0], S::type);
    const base::Matrix Ke = element_stiffness<S>(distorted<S>(), law);
    EXPECT_EQ(zero_eigenvalues(Ke), 1) << nu;
    NodeVectors<S> U = NodeVectors<S>::Zero();
    U.row(1).setOnes();
    EXPECT_LT((Ke * base::Vector(U.reshaped())).norm(), 1e-12 * Ke.norm());
  }
}

// u = (a x, b y): strains a, b, a, all constant; the energy is that of the whole ring.
TYPED_TEST(EveryRing, constant_strain_is_exact) {
  using S = TypeParam;
  const double a = 2e-3;
  const double b = -1e-3;
  for (const double nu : {0.3, 0.4999}) {
    model::Model model = one_element<S>(nu, model::StressState::axisymmetric);
    const ConstitutiveLaw law = constitutive_law(model.materials[0], model.properties[0], S::type);
    base::Vector u(2 * S::nodes);
    double ring = 0.0; // volume
    const NodeVectors<S> X = distorted<S>();
    for (const auto& point : shape::quadrature<S>(9)) {
      ring += point.weight * jacobian<S>(X, point.r).det * 2.0 * std::numbers::pi *
              X.row(0).dot(S::N(point.r));
    }
    for (Eigen::Index n = 0; n < S::nodes; ++n) {
      u[2 * n] = a * X(0, n);
      u[2 * n + 1] = b * X(1, n);
    }
    const double trace = 2.0 * a + b;
    const double along = law.lambda * trace + 2.0 * law.mu * b;
    const double across = law.lambda * trace + 2.0 * law.mu * a;
    for (const Stress& s : element_node_stress(model, model.mesh, u)) {
      EXPECT_NEAR(s[0], across, 1e-10 * std::abs(across));
      EXPECT_NEAR(s[1], along, 1e-10 * std::abs(across));
      EXPECT_NEAR(s[2], across, 1e-10 * std::abs(across));
    }
    const std::vector<base::ElementId> all{base::ElementId(0)};
    const double energy = 0.5 * ring * (2.0 * a * across + b * along);
    EXPECT_NEAR(strain_energy(model, model.mesh, all, u), energy, 1e-6 * std::abs(energy));
  }
}

} // namespace
} // namespace spricka::fe::test_solid_elements
