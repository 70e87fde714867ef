// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/element.hpp"

#include "fe/inverse_map.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <vector>

namespace spricka::fe::test_element {
namespace {

model::ElasticMaterial steel() {
  model::ElasticMaterial material;
  material.E = 210e3;
  material.nu = 0.3;
  return material;
}

ConstitutiveLaw law(model::StressState state, double thickness = 1.0) {
  model::ElementProperty property;
  property.state = state;
  property.thickness = thickness;
  return constitutive_law(steel(), property, base::ElementType::quamc8);
}

template <class S> struct Sample {
  const char* name;
  NodeVectors<S> X;
};

// The reference shape moved, stretched and sheared; corners pushed about; sides curved; quarter
// points at node 0; for quadrilaterals one side collapsed to a point.
template <class S> std::vector<Sample<S>> samples() {
  NodeVectors<S> X;
  for (int i = 0; i < S::nodes; ++i) {
    X.col(i) = shape::node_local_coordinates<S>(i);
  }
  std::vector<Sample<S>> all{{"regular", X}};

  NodeVectors<S> skew = X;
  for (int i = 0; i < S::nodes; ++i) {
    const Eigen::Vector2d r = X.col(i);
    skew.col(i) << 3.0 + 1.3 * r.x() + 0.4 * r.y() + 0.25 * r.x() * r.y(),
        -1.0 - 0.2 * r.x() + 0.7 * r.y() + 0.1 * r.x() * r.y();
  }
  all.push_back({"distorted", skew});
  if constexpr (S::Side::nodes == 3) {
    constexpr int corners = base::element_info(S::type).corners;
    NodeVectors<S> curved = skew;
    curved(1, corners) += 0.08;
    curved(0, corners + 1) -= 0.06;
    all.push_back({"curved", curved});

    NodeVectors<S> quarter = skew;
    quarter.col(corners) = 0.75 * skew.col(0) + 0.25 * skew.col(1);
    quarter.col(2 * corners - 1) = 0.75 * skew.col(0) + 0.25 * skew.col(corners - 1);
    if constexpr (S::nodes == 9) {
      quarter.col(8) = quarter.template leftCols<8>() * shape::Quamc8::N(shape::Point<2>::Zero());
    }
    all.push_back({"quarter-point", quarter});
  }
  if constexpr (S::domain == shape::ReferenceDomain::quadrilateral) {
    NodeVectors<S> collapsed = X;
    for (int i = 0; i < S::nodes; ++i) {
      collapsed(1, i) *= 0.5 * (1.0 + X(0, i));
    }
    all.push_back({"collapsed", collapsed});
  }
  return all;
}

template <class S> class EveryElement : public testing::Test {};
using AllElements =
    testing::Types<shape::Trim3, shape::Trimc6, shape::Quam4, shape::Quamc8, shape::Quamc9>;
TYPED_TEST_SUITE(EveryElement, AllElements);

TYPED_TEST(EveryElement, stiffness_is_the_integral_of_BtDB) {
  using S = TypeParam;
  for (const model::StressState state :
       {model::StressState::plane_stress, model::StressState::plane_strain}) {
    const Elasticity<2> D = elasticity<2>(steel(), state);
    for (const Sample<S>& sample : samples<S>()) {
      base::Matrix expected = base::Matrix::Zero(2 * S::nodes, 2 * S::nodes);
      for (const auto& point : shape::quadrature<S>()) {
        const Jacobian<S> at = jacobian<S>(sample.X, point.r);
        const base::Matrix B = strain_matrix<S>(at.dNdx);
        expected += 2.5 * point.weight * at.det * B.transpose() * D * B;
      }
      const base::Matrix Ke = element_stiffness<S>(sample.X, law(state, 2.5));
      EXPECT_LT((Ke - expected).norm(), 1e-13 * expected.norm()) << sample.name;
      EXPECT_LT((Ke - Ke.transpose()).norm(), 1e-14 * expected.norm()) << sample.name;
    }
  }
}

TYPED_TEST(EveryElement, has_three_rigid_modes_and_no_other_zero) {
  using S = TypeParam;
  for (const model::StressState state :
       {model::StressState::plane_stress, model::StressState::plane_strain}) {
    for (const Sample<S>& sample : samples<S>()) {
      const base::Matrix Ke = element_stiffness<S>(sample.X, law(state));
      const base::Vector values = Eigen::SelfAdjointEigenSolver<base::Matrix>(Ke).eigenvalues();
      const double largest = values[values.size() - 1];
      EXPECT_EQ((values.array().abs() < 1e-10 * largest).count(), 3) << sample.name;
      EXPECT_GT(values[3], 1e-5 * largest) << sample.name;
    }
  }
}

TYPED_TEST(EveryElement, rigid_rotation_makes_no_force) {
  using S = TypeParam;
  const Elasticity<2> D = elasticity<2>(steel(), model::StressState::plane_strain);
  for (const Sample<S>& sample : samples<S>()) {
    NodeVectors<S> U;
    U.row(0) = -sample.X.row(1);
    U.row(1) = sample.X.row(0);
    EXPECT_LT(element_force<S>(sample.X, law(model::StressState::plane_strain), U).norm(),
              1e-12 * D.norm() * U.norm())
        << sample.name;
  }
}

// Compiled for the shape and with the shape as data: one function of the same points.
TYPED_TEST(EveryElement, known_when_run_it_has_the_same_forces) {
  using S = TypeParam;
  const shape::ReferenceElement<2>& element = shape::as_reference_element<S>();
  ConstitutiveLaw projected = law(model::StressState::plane_strain);
  projected.projected = true;
  for (const Sample<S>& sample : samples<S>()) {
    const NodeVectors<S> U =
        (sample.X.array() * sample.X.array() + 0.3 * sample.X.array()).matrix();
    NodeVectors<S> X = sample.X;
    X.row(0).array() += 5.0; // off the axis
    for (const ConstitutiveLaw& one : {law(model::StressState::axisymmetric), projected}) {
      const NodeVectors<S> compiled = element_force<S>(X, one, U);
      const NodeVectors<S> run =
          element_force(element, AnyNodeVectors<2>(X), one, AnyNodeVectors<2>(U));
      EXPECT_LT((run - compiled).norm(), 1e-12 * compiled.norm()) << sample.name;
    }
  }
}

TYPED_TEST(EveryElement, force_is_stiffness_times_displacement) {
  using S = TypeParam;
  const ConstitutiveLaw thin = law(model::StressState::plane_stress, 0.7);
  for (const Sample<S>& sample : samples<S>()) {
    NodeVectors<S> U;
    for (int i = 0; i < U.size(); ++i) {
      U(i) = std::sin(1.0 + 2.0 * i);
    }
    const base::Matrix Ke = element_stiffness<S>(sample.X, thin);
    const base::Vector f = Ke * base::Vector(U.reshaped());
    EXPECT_LT((element_force<S>(sample.X, thin, U).reshaped() - f).norm(), 1e-13 * f.norm())
        << sample.name;
  }
}

TYPED_TEST(EveryElement, jacobian_determinant_integrates_to_the_area) {
  using S = TypeParam;
  const double reference = S::domain == shape::ReferenceDomain::triangle ? 0.5 : 4.0;
  // The affine part of the map has determinant 1.3 * 0.7 + 0.2 * 0.4; the bilinear part adds the
  // integral of d(det), zero on the quadrilateral by symmetry.
  const NodeVectors<S> X = samples<S>()[1].X;
  double area = 0.0;
  for (const auto& point : shape::quadrature<S>()) {
    area += point.weight * jacobian<S>(X, point.r).det;
  }
  if (S::domain == shape::ReferenceDomain::quadrilateral) {
    EXPECT_NEAR(area, 0.99 * reference, 1e-13);
  } else {
    EXPECT_GT(area, 0.9 * reference);
  }
}

TYPED_TEST(EveryElement, inverse_map_finds_points_inside_on_sides_and_at_nodes) {
  using S = TypeParam;
  for (const Sample<S>& sample : samples<S>()) {
    if (std::string(sample.name) == "collapsed") {
      continue; // no unique image on the collapsed side
    }
    std::vector<shape::Point<2>> places{shape::centre<S>(), {0.2, 0.3}, {0.0, 0.5}, {0.4, 0.0}};
    for (int i = 0; i < S::nodes; ++i) {
      places.push_back(shape::node_local_coordinates<S>(i));
      places.push_back(0.999 * shape::node_local_coordinates<S>(i) + 0.001 * shape::centre<S>());
    }
    for (const shape::Point<2>& r : places) {
      const Eigen::Vector2d x = sample.X * S::N(r);
      const auto found = inverse_map<2>(shape::as_reference_element<S>(), sample.X, x);
      ASSERT_TRUE(found.has_value()) << sample.name << ' ' << r.transpose();
      EXPECT_LT((*found - r).norm(), 1e-6) << sample.name << ' ' << r.transpose();
      EXPECT_LT((sample.X * S::N(*found) - x).norm(), 1e-12) << sample.name;
    }
  }
}

TEST(quarter_point, det_is_zero_at_the_tip_only) {
  using S = shape::Trimc6;
  const NodeVectors<S> X = samples<S>().back().X;
  const double scale = jacobian<S>(X, shape::centre<S>()).det;
  EXPECT_NEAR(jacobian<S>(X, shape::node_local_coordinates<S>(0)).det, 0.0, 1e-14 * scale);
  for (int i = 1; i < S::nodes; ++i) {
    EXPECT_GT(jacobian<S>(X, shape::node_local_coordinates<S>(i)).det, 0.1 * scale) << i;
  }
}

// Along both legs of a quarter-point triangle a quadratic in the reference coordinate is
// c0 + c1 sqrt(r) + c2 r: the element holds the crack-tip displacement exactly there.
TEST(quarter_point, represents_the_square_root_along_rays) {
  using S = shape::Trimc6;
  const NodeVectors<S> X = samples<S>().back().X;
  Eigen::Matrix<double, S::nodes, 1> value;
  for (int i = 0; i < S::nodes; ++i) {
    value[i] = std::sqrt((X.col(i) - X.col(0)).norm() / (X.col(1) - X.col(0)).norm());
  }
  for (const double s : {0.05, 0.3, 0.5, 0.9}) {
    const Eigen::Matrix<double, S::nodes, 1> N = S::N({s, 0.0});
    const double r = (X * N - X.col(0)).norm() / (X.col(1) - X.col(0)).norm();
    EXPECT_NEAR(N.dot(value), std::sqrt(r), 1e-13);
  }
}

// Uniaxial tension: sigma_xx = E eps_xx with lateral contraction free in plane stress; in plane
// strain E and nu are replaced by E / (1 - nu^2) and nu / (1 - nu).
TEST(elasticity, closed_forms) {
  const model::ElasticMaterial m = steel();
  const Elasticity<2> stress = elasticity<2>(m, model::StressState::plane_stress);
  const Elasticity<2> strain = elasticity<2>(m, model::StressState::plane_strain);
  const Elasticity<3> solid = elasticity<3>(m, model::StressState::solid);
  const Eigen::Vector3d tension = stress * Eigen::Vector3d(1.0, -m.nu, 0.0);
  EXPECT_NEAR(tension[0], m.E, 1e-9 * m.E);
  EXPECT_NEAR(tension[1], 0.0, 1e-9 * m.E);
  const double nu = m.nu / (1.0 - m.nu);
  const Eigen::Vector3d held = strain * Eigen::Vector3d(1.0, -nu, 0.0);
  EXPECT_NEAR(held[0], m.E / (1.0 - m.nu * m.nu), 1e-9 * m.E);
  EXPECT_NEAR(held[1], 0.0, 1e-9 * m.E);
  Strain<3> eps;
  eps << 1.0, -m.nu, -m.nu, 0.0, 0.0, 0.0;
  EXPECT_LT((solid * eps - m.E * Strain<3>::Unit(0)).norm(), 1e-9 * m.E);
  for (const double shear : {stress(2, 2), strain(2, 2), solid(5, 5)}) {
    EXPECT_NEAR(shear, m.E / (2.0 * (1.0 + m.nu)), 1e-9 * m.E);
  }
  EXPECT_DOUBLE_EQ(effective_modulus(m, model::StressState::plane_stress), m.E);
  EXPECT_DOUBLE_EQ(effective_modulus(m, model::StressState::plane_strain), m.E / 0.91);
}

TEST(strain, follows_the_strain_matrix_in_space) {
  Eigen::Matrix3d H;
  H << 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0;
  Strain<3> expected;
  expected << 1.0, 5.0, 9.0, 6.0, 14.0, 10.0; // xx yy zz xy yz zx
  EXPECT_EQ(strain<3>(H), expected);
  const Eigen::Matrix3d T = stress_tensor<3>(expected);
  EXPECT_EQ(T, T.transpose());
  EXPECT_EQ(T(0, 2), 10.0);
  EXPECT_EQ(T(1, 2), 14.0);
}

} // namespace
} // namespace spricka::fe::test_element
