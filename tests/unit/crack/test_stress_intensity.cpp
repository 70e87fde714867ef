// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/front_intensity.hpp"
#include "crack/front_rows.hpp"
#include "crack/tip_intensity.hpp"
#include "fe/elasticity.hpp"
#include "mesh/generate/generate.hpp"
#include "model/model.hpp"
#include "tests/unit/crack/near_tip.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace spricka::test_stress_intensity {
namespace {

constexpr double K1 = 3.0;
constexpr double K2 = -1.25;

/// An annulus round a tip at the origin, cut along its crack (the negative x axis), that carries
/// the near-tip field itself at its nodes.
struct Annulus {
  model::Model model;
  mesh::CrackedMesh cracked;
  mesh::CrackFront front;
  std::vector<crack::VirtualExtensionField> fields;
  base::Vector u;

  Annulus(int nr, int nt, model::StressState state, base::ElementType type) {
    mesh::RingSpec spec;
    spec.type = type;
    spec.ri = 0.5;
    spec.ro = 1.0;
    spec.nr = nr;
    spec.nt = nt;
    spec.t0 = -std::numbers::pi *
              (1.0 - 1e-9); // a hair open, so that the crack faces keep their own nodes
    spec.t1 = -spec.t0;
    model.nets = {{"", {}}};
    mesh::generate_ring(model.mesh, base::NetId(std::size_t{0}), "", spec);
    model.materials = {{"M", 1000.0, 0.3, 0.0, 0.0, {}}};
    model.properties = {
        {base::ElementSetId(std::size_t{0}), base::MaterialId(std::size_t{0}), state, 1.0, {}}};
    model.mesh.property.assign(model.mesh.element_count(), base::PropertyId(std::size_t{0}));
    cracked.mesh = model.mesh;
    front.tip_point().growth = base::Vec3::UnitX();
    front.a = 1.0;
    front.size = 0.5;
    crack::VirtualExtensionField field;
    for (std::size_t n = 0; n < model.mesh.node_count(); ++n) {
      const double r = model.mesh.x[n].norm();
      field.motion.push_back({.node = base::NodeId(n), .q = (1.0 - r) / 0.5});
    }
    for (std::size_t e = 0; e < model.mesh.element_count(); ++e) {
      field.elements.emplace_back(e);
    }
    fields = {field};
    u.resize(2 * static_cast<Eigen::Index>(model.mesh.node_count()));
    const crack::TipFrame frame;
    for (std::size_t n = 0; n < model.mesh.node_count(); ++n) {
      const base::Vec2 x = model.mesh.x[n].head<2>();
      u.segment<2>(2 * static_cast<Eigen::Index>(n)) =
          K1 * test::near_tip_displacement(frame, x, 1, model.materials[0], state) +
          K2 * test::near_tip_displacement(frame, x, 2, model.materials[0], state);
    }
  }
};

class NearTipField
    : public testing::TestWithParam<std::tuple<model::StressState, base::ElementType>> {};

TEST_P(NearTipField, GivesItsOwnK) {
  const auto [state, type] = GetParam();
  const Annulus a(6, 48, state, type);
  const crack::StressIntensity K =
      crack::front_intensity(a.model, a.cracked, a.front, crack::wrap_tip_domains(a.fields), {},
                             a.u, {})
          .front();
  EXPECT_NEAR(K.K1, K1, 1e-4 * K1);
  EXPECT_NEAR(K.K2, K2, 1e-4 * K1);
  const double E = fe::effective_modulus(a.model.materials[0], state);
  EXPECT_NEAR(K.G, (K1 * K1 + K2 * K2) / E, 1e-4 * K.G);
  EXPECT_NEAR(K.G_from_K, K.G, 1e-4 * K.G);
}

// Interpolation of the field errs by h^3, so K by at least that.
TEST_P(NearTipField, ConvergesToItsOwnK) {
  const auto [state, type] = GetParam();
  double error[2];
  for (int level = 0; level < 2; ++level) {
    const Annulus a(2 << level, 12 << level, state, type);
    const crack::StressIntensity K =
        crack::front_intensity(a.model, a.cracked, a.front, crack::wrap_tip_domains(a.fields), {},
                               a.u, {})
            .front();
    error[level] = std::hypot(K.K1 - K1, K.K2 - K2);
  }
  EXPECT_LT(error[1], error[0] / 6.0);
}

// The finite shift goes to the analytic derivative with the square of the shift.
TEST_P(NearTipField, FiniteShiftTendsToTheAnalyticDerivative) {
  const auto [state, type] = GetParam();
  const Annulus a(4, 32, state, type);
  double error[2];
  for (int i = 0; i < 2; ++i) {
    crack::FrontIntensityOptions request;
    request.shift = i == 0 ? 1e-2 : 1e-3;
    const crack::StressIntensity K =
        crack::front_intensity(a.model, a.cracked, a.front, crack::wrap_tip_domains(a.fields),
                               request, a.u, {})
            .front();
    ASSERT_TRUE(K.shift_error.has_value());
    error[i] = std::abs(*K.shift_error);
  }
  EXPECT_LT(error[0], 1e-2);
  EXPECT_NEAR(error[0] / error[1], 100.0, 5.0);
}

INSTANTIATE_TEST_SUITE_P(States, NearTipField,
                         testing::Combine(testing::Values(model::StressState::plane_stress,
                                                          model::StressState::plane_strain),
                                          testing::Values(base::ElementType::quamc8,
                                                          base::ElementType::quamc9)));

TEST(StressIntensity, RowsGiveTheSameKOfAnyDisplacement) {
  for (const model::CrackTipPlaneState state :
       {model::CrackTipPlaneState::automatic, model::CrackTipPlaneState::strain}) {
    Annulus a(4, 24, model::StressState::plane_stress, base::ElementType::quamc8);
    crack::VirtualExtensionField narrow = a.fields.front(); // a second domain
    for (crack::NodeMotion& moved : narrow.motion) {
      moved.q *= moved.q;
    }
    a.fields.push_back(narrow);
    const base::Matrix rows = crack::front_intensity_functionals(
        a.model, a.cracked, a.front, crack::wrap_tip_domains(a.fields), state);
    for (Eigen::Index i = 0; i < a.u.size(); ++i) {
      a.u[i] += 1e-3 * std::sin(1.7 * static_cast<double>(i * i % 97)); // rough
    }
    crack::FrontIntensityOptions request;
    request.state = state;
    const crack::StressIntensity K =
        crack::front_intensity(a.model, a.cracked, a.front, crack::wrap_tip_domains(a.fields),
                               request, a.u, {})
            .front();
    const double size = rows.cwiseAbs().transpose().row(0).dot(a.u.cwiseAbs());
    EXPECT_NEAR(rows.col(0).dot(a.u), K.K1, 1e-13 * size);
    EXPECT_NEAR(rows.col(1).dot(a.u), K.K2, 1e-13 * size);
    EXPECT_GT(std::abs(K.K1 - K1), 1e-3); // the roughness is seen
  }
}

TEST(StressIntensity, StateOfTheCrackRescalesK) {
  const Annulus a(4, 32, model::StressState::plane_stress, base::ElementType::quamc8);
  crack::FrontIntensityOptions strain;
  strain.state = model::CrackTipPlaneState::strain;
  const double own = crack::front_intensity(a.model, a.cracked, a.front,
                                            crack::wrap_tip_domains(a.fields), {}, a.u, {})
                         .front()
                         .K1;
  const double other = crack::front_intensity(a.model, a.cracked, a.front,
                                              crack::wrap_tip_domains(a.fields), strain, a.u, {})
                           .front()
                           .K1;
  EXPECT_NEAR(other / own, 1.0 / std::sqrt(1.0 - 0.3 * 0.3), 1e-12);
}

} // namespace
} // namespace spricka::test_stress_intensity
