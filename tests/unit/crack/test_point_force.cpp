// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/front_intensity.hpp"
#include "crack/tip_intensity.hpp"
#include "crack/williams.hpp"
#include "fe/element.hpp"
#include "mesh/generate/generate.hpp"
#include "model/model.hpp"
#include "tests/unit/crack/near_tip.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace spricka::test_point_force {
namespace {

using crack::TipFrame;

TipFrame turned(double angle) {
  TipFrame tip;
  tip.x = {0.3, -0.2};
  tip.e1 = {std::cos(angle), std::sin(angle)};
  tip.e2 = {-std::sin(angle), std::cos(angle)};
  return tip;
}

class PointForce : public testing::TestWithParam<model::StressState> {
protected:
  [[nodiscard]] Eigen::Matrix2d stress(const TipFrame& tip, const base::Vec2& x) const {
    const Eigen::Matrix2d H =
        crack::near_tip_gradient(tip, crack::polar_coordinates(tip, x), crack::line_force_auxiliary,
                                 crack::make_section_body(material, GetParam()));
    const fe::Strain<2> s = fe::elasticity<2>(material, GetParam()) * fe::strain<2>(H);
    return fe::stress_tensor<2>(s);
  }
  model::ElasticMaterial material{"M", 210.0, 0.3, 0.0, 0.0, {}};
};

TEST_P(PointForce, GradientIsTheDerivativeOfTheDisplacement) {
  const TipFrame tip = turned(0.7);
  const auto u = [&](const base::Vec2& x) {
    return crack::near_tip_displacement(tip, crack::polar_coordinates(tip, x),
                                        crack::line_force_auxiliary,
                                        crack::make_section_body(material, GetParam()));
  };
  for (const double angle : {-2.9, -1.0, 0.2, 1.7, 3.0}) {
    const base::Vec2 x = tip.x + 0.8 * (std::cos(angle) * tip.e1 + std::sin(angle) * tip.e2);
    const Eigen::Matrix2d H =
        crack::near_tip_gradient(tip, crack::polar_coordinates(tip, x), crack::line_force_auxiliary,
                                 crack::make_section_body(material, GetParam()));
    const double h = 1e-6;
    for (int j = 0; j < 2; ++j) {
      const base::Vec2 d = h * base::Vec2::Unit(j);
      EXPECT_LT(((u(x + d) - u(x - d)) / (2.0 * h) - H.col(j)).norm(), 1e-8 * H.norm());
    }
  }
}

// Radial stress -cos(theta) / (pi r) alone: the crack faces are free, and what a circle carries
// holds the unit force.
TEST_P(PointForce, CarriesAUnitForceAndLeavesTheCrackFacesFree) {
  const TipFrame tip = turned(-0.4);
  base::Vec2 sum = base::Vec2::Zero();
  const int count = 400;
  for (int i = 0; i < count; ++i) {
    const double theta = -std::numbers::pi + 2.0 * std::numbers::pi * (i + 0.5) / count;
    const base::Vec2 n = std::cos(theta) * tip.e1 + std::sin(theta) * tip.e2;
    const double r = 0.6;
    const Eigen::Matrix2d s = stress(tip, tip.x + r * n);
    EXPECT_NEAR(n.dot(s * n), -std::cos(theta) / (std::numbers::pi * r), 1e-12);
    const base::Vec2 along(-n.y(), n.x());
    EXPECT_LT((s * along).norm(), 1e-12);
    sum += (s * n) * (2.0 * std::numbers::pi * r / count);
  }
  EXPECT_NEAR(sum.dot(tip.e1), -1.0, 1e-12);
  EXPECT_NEAR(sum.dot(tip.e2), 0.0, 1e-12);
}

// A ring round the tip, cut along its crack, with displacements that have a T.
TEST_P(PointForce, FindsTheTOfAKnownField) {
  model::Model model;
  mesh::RingSpec spec;
  spec.type = base::ElementType::quamc9;
  spec.ri = 0.5;
  spec.ro = 1.0;
  spec.nr = 6;
  spec.nt = 48;
  spec.t0 = -std::numbers::pi * (1.0 - 1e-9);
  spec.t1 = -spec.t0;
  model.nets = {{"", {}}};
  mesh::generate_ring(model.mesh, base::NetId(std::size_t{0}), "", spec);
  model.materials = {material};
  model.properties = {
      {base::ElementSetId(std::size_t{0}), base::MaterialId(std::size_t{0}), GetParam(), 1.0, {}}};
  model.mesh.property.assign(model.mesh.element_count(), base::PropertyId(std::size_t{0}));
  mesh::CrackedMesh cracked;
  cracked.mesh = model.mesh;
  mesh::CrackFront front;
  front.tip_point().growth = base::Vec3::UnitX();
  front.a = 1.0;
  crack::VirtualExtensionField field;
  const double K1 = 3.0;
  const double K2 = -1.25;
  const double T = -2.5;
  const double kappa = crack::kolosov_constant(material.nu, GetParam());
  const double mu = material.E / (2.0 * (1.0 + material.nu));
  base::Vector u(2 * static_cast<Eigen::Index>(model.mesh.node_count()));
  for (std::size_t n = 0; n < model.mesh.node_count(); ++n) {
    const base::Vec2 x = model.mesh.x[n].head<2>();
    field.motion.push_back({.node = base::NodeId(n), .q = (1.0 - x.norm()) / 0.5});
    u.segment<2>(2 * static_cast<Eigen::Index>(n)) =
        K1 * test::near_tip_displacement({}, x, 1, material, GetParam()) +
        K2 * test::near_tip_displacement({}, x, 2, material, GetParam()) +
        T / (8.0 * mu) * base::Vec2((kappa + 1.0) * x.x(), (kappa - 3.0) * x.y());
  }
  for (std::size_t e = 0; e < model.mesh.element_count(); ++e) {
    field.elements.emplace_back(e);
  }
  const crack::StressIntensity found =
      crack::front_intensity(model, cracked, front, crack::wrap_tip_domains({field}), {}, u, {})
          .front();
  EXPECT_NEAR(found.T, T, 1e-3 * std::abs(T));
  EXPECT_NEAR(found.K1, K1, 1e-3 * K1);
}

INSTANTIATE_TEST_SUITE_P(States, PointForce,
                         testing::Values(model::StressState::plane_stress,
                                         model::StressState::plane_strain));

} // namespace
} // namespace spricka::test_point_force
