// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives of K along a front against differences of solutions.
#include "analysis/adjoint/front_advance.hpp"
#include "analysis/scene/front_functionals.hpp"
#include "fe/assemble.hpp"
#include "tests/places.hpp"
#include "tests/unit/analysis/front_decks.hpp"
#include "tests/unit/support/solved_scene.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace spricka::test_front_sensitivity {
namespace {

struct Values {
  double pull = 1.0, press = 1.0, fit = 1.0, E = 1000.0;
  bool held = false; ///< the upper block is held, so that the fit presses
};

std::optional<test::Solved> solved_with(const Values& v) {
  if (v.held) {
    return test::solve_text(test::pressed_mouth(
        fmt::format("$FREEDOM CLASS=SUPPRESSED DOF=Z\n  B.ZMAX\n$STEP NAME=S\n  FIT ON "
                    "{:.12g}\n  LOAD PULL {:.12g}\n",
                    100.0 * v.fit, v.pull),
        v.E));
  }
  return test::solve_text(
      test::pressed_mouth(fmt::format("$STEP NAME=S\n  FIT ON {:.12g}\n  LOAD PULL {:.12g}\n  LOAD "
                                      "PRESS {:.12g}\n  LOAD TILT 0.4\n",
                                      v.fit, v.pull, v.press),
                          v.E));
}

const results::Sensitivity* find(const results::FrontResult& front,
                                 results::SensitivityParameter cause, const std::string& name) {
  for (const results::Sensitivity& s : front.sensitivities.by_parameter) {
    if (s.cause == cause && s.name == name) {
      return &s;
    }
  }
  return nullptr;
}

// dK = value * derivative times the small part against (K(+) - K(-)) / 2.
void compare(const results::FrontResult& at, const results::Sensitivity* s, double part,
             const Values& up, const Values& down) {
  ASSERT_NE(s, nullptr);
  const auto ahead = solved_with(up);
  const auto behind = solved_with(down);
  ASSERT_TRUE(ahead && behind);
  const results::FrontResult& a = ahead->step().fronts[0];
  const results::FrontResult& b = behind->step().fronts[0];
  double size = 0.0;
  for (std::size_t i = 0; i < at.points.size(); ++i) {
    size = std::max(size, std::abs(s->value * s->above[i][0]));
  }
  ASSERT_GT(size, 0.0);
  for (std::size_t i = 0; i < at.points.size(); ++i) {
    const double scale = part * s->value;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(scale * s->above[i][k], 0.5 * (a.points[i].raw_K()[k] - b.points[i].raw_K()[k]),
                  1e-4 * part * size)
          << i;
    }
  }
}

TEST(Sensitivity, AgreesWithDifferences) {
  const auto solved = solved_with({});
  ASSERT_TRUE(solved);
  const results::FrontResult& front = solved->step().fronts[0];
  ASSERT_TRUE(front.sensitivities.notes.empty()) << front.sensitivities.notes.front();
  constexpr double part = 1e-5;
  compare(front, find(front, results::SensitivityParameter::load, "PULL"), part,
          {.pull = 1.0 + part}, {.pull = 1.0 - part});
  if (test::full_size()) {
    compare(front, find(front, results::SensitivityParameter::load, "PRESS"), part,
            {.press = 1.0 + part}, {.press = 1.0 - part});
  }
  compare(front, find(front, results::SensitivityParameter::modulus, "M"), part,
          {.E = 1000.0 * (1.0 + part)}, {.E = 1000.0 * (1.0 - part)});
}

TEST(Sensitivity, OfAFitAgreesWithDifferences) {
  const auto solved = solved_with({.held = true});
  ASSERT_TRUE(solved);
  const results::FrontResult& front = solved->step().fronts[0];
  ASSERT_TRUE(front.sensitivities.notes.empty()) << front.sensitivities.notes.front();
  constexpr double part = 1e-5;
  compare(front, find(front, results::SensitivityParameter::fit, "ON"), part,
          {.fit = 1.0 + part, .held = true}, {.fit = 1.0 - part, .held = true});
}

// K at the end of a step of the mesh as it is or, where an axis is named, with that axis longer by
// the step of its derivative.
struct Grown {
  base::Vector K;
  double step = 0.0;
};
Grown grown(const std::string& text, std::optional<analysis::EllipseAxis> axis) {
  Grown out;
  test::SolvedScene::Changes changes;
  if (axis) {
    changes.scene = [&](analysis::Discretisation& scene, const model::Model& model) {
      const analysis::VirtualAxisExtension advance(model, scene, base::CrackId(0), *axis);
      out.step = advance.axis_increment();
      scene.cracked.mesh = advance.extended_discretisation().cracked.mesh;
      scene.cracked.fronts = advance.extended_discretisation().cracked.fronts;
      scene.domains = advance.extended_discretisation().domains;
      scene.pairs = advance.extended_discretisation().pairs;
      for (std::size_t c = 0; c < model.cases.size(); ++c) {
        scene.case_load.col(static_cast<Eigen::Index>(c)) =
            fe::consistent_load_vector(model, scene.cracked.mesh, model.cases[c]);
      }
    };
  }
  test::SolvedScene solved(text, changes);
  if (const auto state = solved.solve(0)) {
    out.K =
        analysis::evaluate_K_values(solved.model(), solved.scene(), state->u, state->case_factor);
    base::Vector lambda(static_cast<Eigen::Index>(solved.scene().table.size()));
    for (std::size_t c = 0; c < solved.scene().pairs.size(); ++c) {
      lambda.segment(static_cast<Eigen::Index>(solved.scene().table.first[c]),
                     state->pair_lambda[c].size()) = state->pair_lambda[c];
    }
    out.K += analysis::contact_force_K_functionals(solved.model(), solved.scene()) * lambda;
  }
  return out;
}

// A mesh that goes along with a longer axis, solved: by an axis the derivative is that of the
// discrete K, with the mouth in a contact that presses, under tension and under pressure on the
// faces.
TEST(Sensitivity, OfAxesAgreesWithDifferences) {
  const std::string text = test::pressed_mouth(
      "$LOAD CASE=INSIDE TYPE=FACES\n  C (1 + y)\n$STEP NAME=S\n  FIT ON 1\n  LOAD PULL 1\n"
      "  LOAD PRESS 1\n  LOAD TILT 0.4\n  LOAD INSIDE 1\n");
  const auto solved = test::solve_text(text);
  ASSERT_TRUE(solved);
  const results::FrontResult& front = solved->step().fronts[0];
  ASSERT_TRUE(front.sensitivities.notes.empty()) << front.sensitivities.notes.front();
  const Grown now = grown(text, {});
  for (const analysis::EllipseAxis axis : {analysis::EllipseAxis::a, analysis::EllipseAxis::c}) {
    const Grown more = grown(text, axis);
    const results::Sensitivity* s =
        find(front,
             axis == analysis::EllipseAxis::a ? results::SensitivityParameter::length
                                              : results::SensitivityParameter::axis,
             "C");
    ASSERT_NE(s, nullptr);
    ASSERT_EQ(more.K.size(), now.K.size());
    const base::Vector rate = (more.K - now.K) / more.step;
    double size = 0.0;
    for (const std::array<double, 3>& point : s->above) {
      size = std::max(size, std::abs(point[0]));
    }
    EXPECT_GT(size, 0.2 * front.points[0].K1);
    for (std::size_t i = 0; i < s->above.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(s->above[i][k], rate[static_cast<Eigen::Index>(3 * i + k)], 1e-4 * size)
            << i << " K" << k + 1;
      }
    }
  }
}

// K of an embedded ellipse (Irwin 1962), here of the circle: an axis alone, and both, which make K1
// grow as the root of the radius does, and in this block by 1.5 % more: (K(1.1) - K(0.9)) / 0.2 of
// solutions, means along the front, is 0.573.
TEST(Sensitivity, OfAxesIsThatOfAnEllipse) {
  const auto solved = test::solve_text(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=B
  $MESH SHAPE=BLOCK TYPE=TET10 X0=-8 Y0=-8 Z0=-8 LX=16 LY=16 LZ=16 NX=3 NY=3 NZ=3
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=B.BODY MATERIAL=M STATE=SOLID
$NSET NAME=P1 WHERE=(x < -7.99 and y < -7.99 and z < -7.99)
$NSET NAME=P2 WHERE=(x > 7.99 and y < -7.99 and z < -7.99)
$NSET NAME=P3 WHERE=(x < -7.99 and y > 7.99 and z < -7.99)
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  P1
$FREEDOM CLASS=SUPPRESSED DOF=YZ
  P2
$FREEDOM CLASS=SUPPRESSED DOF=Z
  P3
$CRACK NAME=C NET=B A=1 C=1 X0=0 Y0=0 Z0=0 NORMAL=Z
$LOAD CASE=UP TYPE=TRACTION
  B.ZMAX 0 0 1
  B.ZMIN 0 0 -1
$STEP NAME=S
  LOAD UP 1
$END
)");
  ASSERT_TRUE(solved);
  const results::FrontResult& front = solved->step().fronts[0];
  const results::Sensitivity* a = find(front, results::SensitivityParameter::length, "C");
  const results::Sensitivity* c = find(front, results::SensitivityParameter::axis, "C");
  ASSERT_TRUE(a != nullptr && c != nullptr);
  const double K = 2.0 / std::sqrt(std::numbers::pi);
  for (std::size_t i = 0; i < front.points.size(); ++i) {
    const double phi = front.points[i].phi;
    // d ln K/da at a = c of (sin^2 phi + (a/c)^2 cos^2 phi)^(1/4) sqrt(pi a) / E
    EXPECT_NEAR(a->above[i][0], 0.5 * K * std::pow(std::cos(phi), 2), 0.012 * K) << phi;
    EXPECT_NEAR(c->above[i][0], 0.5 * K * std::pow(std::sin(phi), 2), 0.012 * K) << phi;
    EXPECT_NEAR(a->above[i][0] + c->above[i][0], 0.573, 0.008 * K) << phi;
  }
}

// K is the sum of what loads and fits do to it.
TEST(Sensitivity, LoadsAndFitsAddUpToK) {
  const auto solved = solved_with({});
  ASSERT_TRUE(solved);
  const results::FrontResult& front = solved->step().fronts[0];
  for (std::size_t i = 0; i < front.points.size(); ++i) {
    double sum = 0.0;
    for (const results::Sensitivity& s : front.sensitivities.by_parameter) {
      if (s.cause == results::SensitivityParameter::load ||
          s.cause == results::SensitivityParameter::fit) {
        sum += s.value * s.above[i][0];
      }
    }
    EXPECT_NEAR(sum, front.points[i].raw_K()[0], 1e-9 * front.points[i].K1) << i;
  }
}

} // namespace
} // namespace spricka::test_front_sensitivity
