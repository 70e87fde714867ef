// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/assemble.hpp"
#include "model/model.hpp"
#include "tests/places.hpp"
#include "tests/unit/support/pinned_ring.hpp"
#include "tests/unit/support/solved_scene.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <cmath>
#include <variant>

#include <fmt/format.h>

// Derivatives of K against differences of whole solutions.
namespace spricka::test_sensitivity {
namespace {

using results::Sensitivity;
using results::SensitivityParameter;
using test::SolvedScene;

using Pair = std::array<double, 2>;
using Modes = std::array<double, 3>;

const Sensitivity& find(const results::FrontResult& front, SensitivityParameter cause,
                        const std::string& name) {
  for (const Sensitivity& s : front.sensitivities.by_parameter) {
    if (s.cause == cause && s.name == name) {
      return s;
    }
  }
  throw std::runtime_error("no derivative by " + name);
}

// K1 and K2 of the first tip at the end of the last step, the model or the scene changed.
base::Vec2 K_of(const std::string& deck, const SolvedScene::Changes& changes) {
  SolvedScene solved(deck, changes);
  const std::size_t steps = solved.model().steps.size();
  for (std::size_t s = 0; s + 1 < steps; ++s) {
    solved.solve(s);
  }
  const std::optional<results::LoadStepResult> last = solved.found(steps - 1);
  if (!last) {
    return base::Vec2::Zero();
  }
  const results::FrontPointResult& tip = last->fronts[0].single_point();
  return {tip.raw_K()[0], tip.raw_K()[1]};
}

// Central difference of both by a change of `by` [1 or -1] times h.
base::Vec2 difference(const std::string& deck, double h,
                      const std::function<SolvedScene::Changes(double)>& by) {
  return (K_of(deck, by(h)) - K_of(deck, by(-h))) / (2.0 * h);
}

void expect_slope(const Sensitivity& s, const base::Vec2& wanted, double tolerance) {
  ASSERT_TRUE(s.is_smooth()) << s.name;
  const base::Vec2 found(s.below.at(0)[0], s.below.at(0)[1]);
  EXPECT_LT((found - wanted).norm(), tolerance * wanted.norm())
      << results::display_word(s.cause) << " " << s.name << ": " << found.transpose() << " against "
      << wanted.transpose();
}

void scale_load(model::Model& model, double factor) {
  for (model::StepAction& action : model.steps.back().actions) {
    if (auto* load = std::get_if<model::ApplyLoad>(&action)) {
      load->factor *= factor;
    }
  }
}

// All derivatives of the first tip at the last step's end; h: relative changes small enough to
// keep the contact.
void compare_with_differences(const std::string& deck, double h) {
  SolvedScene solved(deck);
  std::optional<results::LoadStepResult> last;
  for (std::size_t s = 0; s < solved.model().steps.size(); ++s) {
    last = solved.found(s);
    ASSERT_TRUE(last);
  }
  const results::FrontResult& front = last->fronts[0];
  for (const Sensitivity& s : front.sensitivities.by_parameter) {
    if (s.value == 0.0) {
      continue;
    }
    base::Vec2 wanted;
    if (s.cause == SensitivityParameter::load) {
      wanted = difference(deck, h, [](double by) {
        return SolvedScene::Changes{[by](model::Model& m) { scale_load(m, 1.0 + by); }, {}};
      });
    } else if (s.cause == SensitivityParameter::fit) {
      wanted = difference(deck, h, [](double by) {
        return SolvedScene::Changes{[by](model::Model& m) { *m.contacts[0].gap *= 1.0 + by; }, {}};
      });
    } else if (s.cause == SensitivityParameter::modulus) {
      std::size_t m = 0;
      while (solved.model().materials[m].name != s.name) {
        ++m;
      }
      wanted = difference(deck, h, [m](double by) {
        return SolvedScene::Changes{[m, by](model::Model& c) { c.materials[m].E *= 1.0 + by; }, {}};
      });
    } else {
      continue;
    }
    expect_slope(s, wanted / s.value, 1e-5);
  }
}

std::string rings(const std::string& steps) {
  return test::pinned_ring({.hub_rings = 3, .pin_rings = 2, .sectors = 24, .crack_at = 80.0},
                           steps);
}

const std::string press_and_pull = R"($STEP NAME=PRESS
  FIT FIT 1
$STEP NAME=PULLED
  LOAD PULL 0.9
)";

std::string lug(double factor) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$INCLUDE FILE='{}/lug_model.inc'
$CONTACT NAME=BUSH SLAVE=SLEEVE.OUTER MASTER=LUG.BORE DIAMETRAL=0.084
$CONTACT NAME=PIN  SLAVE=SHAFT.OUTER  MASTER=SLEEVE.INNER GAP=0
$STEP NAME=PRESS
  FIT BUSH 1
$STEP NAME=LOADED
  LOAD SHAFTLOAD {}
$CRACK NAME=TOP NET=LUG A0=(0.3*R) ANGLE=90[deg] STATE=STRESS
  0 (R)
$END
)",
                     test::decks_folder(), factor);
}

// An edge crack in a strip that is pulled, bent by displacements and heavy.
std::string strip(double a) {
  return "$DECK VERSION=1 LENGTH=mm FORCE=N\n" +
         fmt::format(R"($MESH SHAPE=BLOCK TYPE=QUAMC8 LX=20 LY=60 NX=8 NY=24
$MATERIAL NAME=M E=70000 NU=0.3 ALPHA=2e-5
$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN
$NSET NAME=PIN WHERE=(abs(x) + abs(y) < 1e-6)
$FREEDOM CLASS=SUPPRESSED DOF=X
  PIN
$FREEDOM CLASS=SUPPRESSED DOF=Y
  YMIN
$FREEDOM CLASS=PRESCRIBED DOF=Y
  XMAX
$LOAD CASE=PULL TYPE=TRACTION
  YMAX 5 100
$LOAD CASE=BEND TYPE=DISP
  XMAX 0 (0.0005*y)
$LOAD CASE=WEIGHT TYPE=BODY
  BODY 0 (1 + 0.1*x)
$CRACK NAME=C ANGLE=0 A0={}
  0 30
$STEP NAME=S
  LOAD PULL 1
  LOAD BEND 0.7
  LOAD WEIGHT 2
$END
)",
                     a);
}

TEST(Sensitivity, OfAPressedPinAgreesWithDifferences) {
  compare_with_differences(rings(press_and_pull), 1e-5);
}

TEST(Sensitivity, OfTheLugAgreesWithDifferences) {
  compare_with_differences(lug(1.0), 1e-5);
}

// What comes out of the adjoint adds up: K is homogeneous in loads and fits, and what all moduli
// divide multiplies the fits.
TEST(Sensitivity, AddsUp) {
  for (const std::string& deck : {rings(press_and_pull), lug(0.7)}) {
    SolvedScene solved(deck);
    for (const std::size_t step : {0U, 1U}) {
      const std::optional<results::LoadStepResult> found = solved.found(step);
      ASSERT_TRUE(found);
      const results::FrontResult& front = found->fronts[0];
      Pair loads{0.0, 0.0};
      Pair fits{0.0, 0.0};
      Pair moduli{0.0, 0.0};
      for (const Sensitivity& s : front.sensitivities.by_parameter) {
        ASSERT_TRUE(s.is_smooth());
        for (const std::size_t k : {0U, 1U}) {
          const double part = s.value * s.below.at(0)[k];
          loads[k] += s.cause == SensitivityParameter::load ? part : 0.0;
          fits[k] += s.cause == SensitivityParameter::fit ? part : 0.0;
          moduli[k] += s.cause == SensitivityParameter::modulus ? part : 0.0;
        }
      }
      const Pair K{front.single_point().raw_K()[0], front.single_point().raw_K()[1]};
      for (const std::size_t k : {0U, 1U}) {
        EXPECT_NEAR(loads[k] + fits[k], K[k], 1e-11 * std::abs(front.single_point().K1));
        EXPECT_NEAR(moduli[k], fits[k], 1e-10 * std::abs(front.single_point().K1));
      }
      EXPECT_GT(std::abs(fits[0]), 0.01 * front.single_point().K1);
    }
  }
}

// Nodes that move with the tip on the same patch: the derivative of the discrete K itself.
void compare_with_moved_nodes(const std::string& deck) {
  SolvedScene solved(deck);
  std::optional<results::LoadStepResult> last;
  for (std::size_t s = 0; s < solved.model().steps.size(); ++s) {
    last = solved.found(s);
    ASSERT_TRUE(last);
  }
  const results::FrontResult& front = last->fronts[0];
  std::vector<int> left_out;
  const int wide = solved.scene().domains[0].points.front().back().rings + 1;
  const estimate::TipMeshMotion motion = estimate::make_tip_mesh_motion(
      solved.scene().cracked, 0,
      crack::TipNeighbourhood(solved.scene().cracked.mesh)
          .extension_fields(solved.scene().cracked, solved.scene().cracked.fronts[0], {wide},
                            left_out)
          .at(0));
  const auto moved = [&motion](double by) {
    return SolvedScene::Changes{
        {}, [&motion, by](analysis::Discretisation& scene, const model::Model& model) {
          scene.cracked = estimate::move_tip_mesh(scene.cracked, motion, by);
          for (std::size_t c = 0; c < model.cases.size(); ++c) {
            scene.case_load.col(static_cast<Eigen::Index>(c)) =
                fe::consistent_load_vector(model, scene.cracked.mesh, model.cases[c]);
          }
        }};
  };
  const base::Vec2 wanted = difference(deck, 10.0, moved) / motion.step; // ten steps of the motion
  expect_slope(find(front, SensitivityParameter::length, "C"), wanted, 1e-5);
}

TEST(Sensitivity, ByLengthIsThatOfTheMovedMesh) {
  compare_with_moved_nodes(strip(7.0));
  compare_with_moved_nodes(rings(press_and_pull));
}

TEST(Sensitivity, ByLengthAgreesWithNewPatches) {
  const auto by_length = [](const std::string& deck) {
    SolvedScene solved(deck);
    std::optional<results::LoadStepResult> last;
    for (std::size_t s = 0; s < solved.model().steps.size(); ++s) {
      last = solved.found(s);
    }
    const results::FrontResult& front = last->fronts[0];
    const Sensitivity& slope = find(front, SensitivityParameter::length, front.name);
    EXPECT_TRUE(slope.is_smooth());
    return slope.below.at(0)[0];
  };
  const double da = 0.2;
  const double wanted = (K_of(strip(7.0 + da), {})[0] - K_of(strip(7.0 - da), {})[0]) / (2.0 * da);
  EXPECT_NEAR(by_length(strip(7.0)), wanted, 0.005 * std::abs(wanted));
  const auto lug_of = [](double a) {
    std::string deck = lug(1.0);
    deck.replace(deck.find("(0.3*R)"), 7, fmt::format("{}", a));
    return deck;
  };
  const double ahead = K_of(lug_of(11.3), {})[0];
  const double behind = K_of(lug_of(10.3), {})[0];
  EXPECT_NEAR(by_length(lug_of(10.8)), ahead - behind, 0.005 * (ahead - behind));
}

TEST(Sensitivity, WithDisplacementsAndWeightAgreesWithDifferences) {
  const std::string deck = strip(7.0);
  SolvedScene solved(deck);
  const std::optional<results::LoadStepResult> last = solved.found(0);
  ASSERT_TRUE(last);
  const results::FrontResult& front = last->fronts[0];
  for (const std::size_t a : {0U, 1U, 2U}) {
    const auto& action = std::get<model::ApplyLoad>(solved.model().steps[0].actions[a]);
    const base::Vec2 wanted = difference(deck, 1e-3, [a](double by) {
      return SolvedScene::Changes{[a, by](model::Model& m) {
                                    std::get<model::ApplyLoad>(m.steps[0].actions[a]).factor += by;
                                  },
                                  {}};
    });
    expect_slope(find(front, SensitivityParameter::load,
                      solved.model().cases[action.load_case.index()].name),
                 wanted, 1e-9);
  }
  const base::Vec2 wanted = difference(deck, 1e-4, [](double by) {
    return SolvedScene::Changes{[by](model::Model& m) { m.materials[0].E *= 1.0 + by; }, {}};
  });
  expect_slope(find(front, SensitivityParameter::modulus, "M"), wanted / 70000.0, 1e-6);
}

// A load path knows all breakpoints: between two of them they are the range, on one of them the
// slopes on both sides are those of the path.
TEST(Sensitivity, KnowsItsRangeAndBothSidesOfABreakpoint) {
  const auto path_run = test::solve_text_with_raw_K(rings(R"($STEP NAME=PRESS
  FIT FIT 1
$STEP NAME=PULLED
  LOAD PULL 1
$LOADPATH NAME=UP FROM=PRESS TO=PULLED
)"));
  ASSERT_TRUE(path_run);
  const results::LoadPathResult& path = path_run->run.increments[0].paths[0];
  ASSERT_GT(path.t.size(), 8U);
  const std::size_t k = path.t.size() / 2;
  const auto at = [&](double t) {
    SolvedScene solved(rings(fmt::format("$STEP NAME=P\n  FIT FIT 1\n  LOAD PULL {:.17g}\n", t)));
    std::optional<results::LoadStepResult> found = solved.found(0);
    EXPECT_TRUE(found);
    return find(found->fronts[0], SensitivityParameter::load, "PULL");
  };
  const base::PiecewiseLinear& K1 = path.fronts[0].single_point().K[0];
  const base::PiecewiseLinear& K2 = path.fronts[0].single_point().K[1];
  const double size = std::abs(K1.slope(k));
  const Sensitivity inside = at(0.5 * (path.t[k] + path.t[k + 1]));
  ASSERT_TRUE(inside.is_smooth() && inside.range);
  EXPECT_NEAR(inside.below.at(0)[0], K1.slope(k), 1e-9 * size);
  EXPECT_NEAR(inside.below.at(0)[1], K2.slope(k), 1e-9 * size);
  EXPECT_NEAR((*inside.range)[0], path.t[k], 1e-9);
  EXPECT_NEAR((*inside.range)[1], path.t[k + 1], 1e-9);
  const Sensitivity corner = at(path.t[k]);
  ASSERT_TRUE(!corner.below.empty() && !corner.above.empty() && corner.range);
  EXPECT_FALSE(corner.is_smooth());
  EXPECT_GT(std::abs(K1.slope(k) - K1.slope(k - 1)), 1e-5 * size); // it is a corner
  EXPECT_NEAR(corner.below[0][0], K1.slope(k - 1), 1e-9 * size);
  EXPECT_NEAR(corner.above[0][0], K1.slope(k), 1e-9 * size);
  EXPECT_NEAR((*corner.range)[0], path.t[k - 1], 1e-7);
  EXPECT_NEAR((*corner.range)[1], path.t[k + 1], 1e-7);
}

// What is not given says why, also to a check.
TEST(Sensitivity, ThatIsNotGivenSaysWhy) {
  const auto messages = [](const std::string& deck) {
    const test::Folder folder;
    const test::Outcome outcome = test::run_text(folder, deck);
    EXPECT_EQ(outcome.exit_code, 1);
    return outcome.messages;
  };
  std::string rubbing = rings(press_and_pull + "$CHECK\n  DK1.LOAD(C, PULLED, PULL) = 1 ABS 1e9\n");
  rubbing.replace(rubbing.find("INTERFERENCE=0.01"), 17, "INTERFERENCE=0.01 MU=0.2");
  EXPECT_NE(messages(rubbing).find("contacts rub"), std::string::npos);
  const std::string late = rings(R"($LOAD CASE=SIDE TYPE=TRACTION
  HUB.OUTER 1 0
$STEP NAME=FIRST
  LOAD SIDE 1
$STEP NAME=THEN
  MOUNT FIT
$CHECK
  DK1.E(C, THEN, S) = 1 ABS 1e9
)");
  EXPECT_NE(messages(late).find("mounted on deformed"), std::string::npos);
}

// A temperature like the root of the distance from the tip, as beside insulated cracks: a tip that
// moves on leaves that field, one that moves back leaves it as well, and K has no slope there. A
// temperature that bends smoothly over the same plate has one.
TEST(Sensitivity, WhereATemperatureIsSingularAtTheTipIsNotGiven) {
  const auto by_length = [](const std::string& temperature) {
    SolvedScene solved(fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 X0=-10 Y0=-10 LX=20 LY=20 NX=6 NY=6
$NSET NAME=O WHERE=(x < -9.9 and y < -9.9)
$NSET NAME=A WHERE=(x > 9.9 and y < -9.9)
$MATERIAL NAME=AL E=70000 NU=0.33 ALPHA=2.4e-5
$PROPERTY ESET=BODY MATERIAL=AL STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  O
$FREEDOM CLASS=SUPPRESSED DOF=Y
  A
$CRACK NAME=C FACES=FREE
  -10 0
  0.5 0
$LOAD CASE=HEAT TYPE=TEMPERATURE
  BODY ({})
$LOAD CASE=PULL TYPE=TRACTION
  YMAX 0 100
  YMIN 0 -100
$STEP NAME=FLUX
  LOAD HEAT 1
  LOAD PULL 1
$END
)",
                                   temperature));
    const std::optional<results::LoadStepResult> found = solved.found(0);
    EXPECT_TRUE(found);
    return found->fronts[0].sensitivities;
  };
  const auto given = [](const results::FrontKSensitivities& all) {
    return std::ranges::any_of(all.by_parameter, [](const Sensitivity& s) {
      return s.cause == SensitivityParameter::length && s.is_smooth();
    });
  };
  const auto singular = by_length("100*sqrt(sqrt((x-0.5)^2+y^2))");
  EXPECT_FALSE(given(singular));
  EXPECT_TRUE(std::ranges::any_of(singular.notes, [](const std::string& note) {
    return note.find("singular at the tip") != std::string::npos;
  }));
  EXPECT_TRUE(given(by_length("10*y*(1+0.2*x)+30*cos(x)")));
}

// Before anything is loaded every row is at a change: the directions differ.
TEST(Sensitivity, OfANetFitBeforeItIsLoaded) {
  std::string deck = rings("$STEP NAME=NONE\n  LOAD PULL 0\n");
  deck.replace(deck.find("INTERFERENCE=0.01"), 17, "GAP=0");
  SolvedScene solved(deck);
  const std::optional<results::LoadStepResult> none = solved.found(0);
  ASSERT_TRUE(none);
  const Sensitivity& pull = find(none->fronts[0], SensitivityParameter::load, "PULL");
  ASSERT_TRUE(!pull.below.empty() && !pull.above.empty());
  for (const double sign : {1.0, -1.0}) {
    std::string loaded = deck;
    loaded.replace(loaded.find("LOAD PULL 0"), 11, fmt::format("LOAD PULL {}", sign));
    const base::Vec2 K = K_of(loaded, {}); // a net fit: proportional to the load
    const Modes& side = sign > 0.0 ? pull.above[0] : pull.below[0];
    EXPECT_NEAR(sign * side[0], K[0], 1e-9 * K.norm());
    EXPECT_NEAR(sign * side[1], K[1], 1e-9 * K.norm());
  }
}

} // namespace
} // namespace spricka::test_sensitivity
