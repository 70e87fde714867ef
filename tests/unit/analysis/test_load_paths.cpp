// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/piecewise_linear.hpp"
#include "tests/places.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <cmath>
#include <cstdlib>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace spricka::test_load_paths {
namespace {

using test::Folder;
using test::run_text;
using test::solve_text_with_raw_K;
using test::Solved;

// Two rings, one pressed into the other and pulled; `more`: cards behind the steps.
std::string rings(const std::string& contact, const std::string& steps) {
  return R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=HUB
  $MESH SHAPE=RING TYPE=QUAMC8 RI=20 RO=50 NR=4 NT=36
$ENDNET
$NET NAME=PIN
  $MESH SHAPE=RING TYPE=QUAMC8 RI=5 RO=20 NR=4 NT=32
$ENDNET
$MATERIAL NAME=S E=210000 NU=0.3
$PROPERTY ESET=HUB.BODY MATERIAL=S STATE=STRESS THICK=10
$PROPERTY ESET=PIN.BODY MATERIAL=S STATE=STRESS THICK=10
$NSET NAME=HELD WHERE=(x < -44)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  HELD
$LOAD CASE=PULL TYPE=RESULTANT
  PIN.BODY 20000 3000
)" + contact +
         steps + "$END\n";
}

const std::string press_fit = "$CONTACT NAME=FIT SLAVE=PIN.OUTER MASTER=HUB.INNER "
                              "INTERFERENCE=0.01\n";

// The lug's literal decks with one crack length and 31 steps along the path.
std::string lug(const std::string& tips, double ratio) {
  std::string deck = fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$INCLUDE FILE='{}/lug_model.inc'
$CONTACT NAME=BUSH SLAVE=SLEEVE.OUTER MASTER=LUG.BORE DIAMETRAL=0.084
$CONTACT NAME=PIN  SLAVE=SHAFT.OUTER  MASTER=SLEEVE.INNER GAP=0
$STEP NAME=PRESS
  FIT BUSH 1
)",
                                 test::decks_folder());
  for (int k = 1; k <= 31; ++k) {
    deck += fmt::format("$STEP NAME=F{}\n  LOAD SHAFTLOAD ({}/20)\n", k, k);
  }
  deck += "$LOADPATH NAME=UP FROM=PRESS TO=F20 BEYOND=1.55\n";
  deck += "$LOADPATH NAME=DOWN FROM=F31 TO=PRESS\n";
  for (const char tip : tips) {
    const bool top = tip == 'T';
    deck += fmt::format("$CRACK NAME={} NET=LUG A0=({}*R) ANGLE={}[deg] STATE=STRESS\n  0 ({}R)\n",
                        top ? "TOP" : "LOW", ratio, top ? 90 : -90, top ? "" : "-");
  }
  return deck + "$END\n";
}

// Every step between lies on the path: K of both must agree.
void compare_with_steps(const Solved& solved) {
  const results::CrackLengthResult& increment = solved.run.increments.front();
  const results::LoadPathResult* up = results::find_path(increment, "UP");
  const results::LoadPathResult* down = results::find_path(increment, "DOWN");
  ASSERT_NE(up, nullptr);
  ASSERT_NE(down, nullptr);
  EXPECT_TRUE(up->stopped.empty());
  EXPECT_GT(up->t.size(), 50U);
  ASSERT_EQ(up->t.size(), down->t.size());
  for (std::size_t k = 0; k < up->t.size(); ++k) { // the way back
    EXPECT_NEAR(up->t[k], 1.55 * (1.0 - down->t[down->t.size() - 1 - k]), 1e-9);
  }
  for (const results::LoadPathFront& front : up->fronts) {
    const results::LoadPathFrontPoint& tip = front.single_point();
    const double size = tip.K[0].largest_value();
    for (std::size_t s = 0; s < increment.steps.size(); ++s) {
      const double t = static_cast<double>(s) / 20.0;
      const results::FrontResult* at =
          results::find_front(increment.steps[s], front.front_without_points.name);
      EXPECT_NEAR(tip.K[0](t), at->single_point().K1, 1e-11 * size)
          << front.front_without_points.name << " at " << t;
      EXPECT_NEAR(tip.K[1](t), at->single_point().K2, 1e-11 * size)
          << front.front_without_points.name << " at " << t;
    }
    // the sum of two states of proportional data
    EXPECT_NEAR(results::k_at_load_combination(*up, tip, 1, 0.3, 0.7).value(), tip.K[0](0.7),
                1e-12 * size);
    EXPECT_NEAR(results::k_at_load_combination(*up, tip, 1, 0.6, 1.4).value(), 2.0 * tip.K[0](0.7),
                1e-12 * size);
    EXPECT_FALSE(
        results::k_at_load_combination(*up, tip, 1, -2.0, 3.0).has_value()); // beyond the path
  }
}

TEST(LoadPathSolver, LugAgreesWithThirtyOneLoads) {
  const bool full = test::full_size();
  const std::vector<double> ratios =
      full ? std::vector<double>{0.05, 0.1, 0.2, 0.3, 0.5, 0.8} : std::vector<double>{0.8};
  for (const double ratio : ratios) {
    for (const char* tips : {"T", "TL"}) {
      if (!full && std::string(tips) == "TL") {
        continue;
      }
      SCOPED_TRACE(fmt::format("{} {}", tips, ratio));
      const std::optional<Solved> solved = solve_text_with_raw_K(lug(tips, ratio));
      ASSERT_TRUE(solved);
      compare_with_steps(*solved);
    }
  }
}

TEST(LoadPathSolver, LoadAndFitTurnIntoEachOther) {
  // from press fit alone to load alone: one path is the whole map of both
  const std::optional<Solved> solved = solve_text_with_raw_K(rings(press_fit, R"($STEP NAME=PRESS
  FIT FIT 1
$STEP NAME=BOTH
  FIT FIT 0.6
  LOAD PULL 0.8
$STEP NAME=PULLED
  FIT FIT 0
  LOAD PULL 1
$LOADPATH NAME=TURN FROM=PRESS TO=PULLED
$CRACK NAME=C NET=HUB ANGLE=90[deg] A0=4
  0 20
)"));
  ASSERT_TRUE(solved);
  const results::CrackLengthResult& increment = solved->run.increments.front();
  const results::LoadPathResult& path = increment.paths.front();
  EXPECT_TRUE(path.homogeneous);
  EXPECT_LT(path.mismatch, 1e-11);
  const results::LoadPathFrontPoint& tip = path.fronts.front().single_point();
  EXPECT_NEAR(results::k_at_load_combination(path, tip, 1, 0.6, 0.8).value(),
              increment.steps[1].fronts[0].single_point().K1, 1e-11 * tip.K[0].largest_value());
  EXPECT_NEAR(results::k_at_load_combination(path, tip, 2, 0.6, 0.8).value(),
              increment.steps[1].fronts[0].single_point().K2, 1e-11 * tip.K[0].largest_value());
}

TEST(LoadPathSolver, AClearanceThatNoFitScalesIsAThirdParameter) {
  const std::optional<Solved> solved =
      solve_text_with_raw_K(rings("$CONTACT NAME=FIT SLAVE=PIN.OUTER MASTER=HUB.INNER GAP=0.01\n",
                                  R"($STEP NAME=LITTLE
  LOAD PULL 0.1
$STEP NAME=MUCH
  LOAD PULL 1
$LOADPATH NAME=UP FROM=LITTLE TO=MUCH
$CRACK NAME=C NET=HUB ANGLE=90[deg] A0=4
  0 20
)"));
  ASSERT_TRUE(solved);
  const results::LoadPathResult& path = solved->run.increments.front().paths.front();
  EXPECT_FALSE(path.homogeneous);
  EXPECT_FALSE(results::k_at_load_combination(path, path.fronts.front().single_point(), 1, 1.0, 1.0)
                   .has_value());
  EXPECT_TRUE(results::k_at_load_combination(path, path.fronts.front().single_point(), 1, 0.5, 0.5)
                  .has_value());
  EXPECT_LT(path.mismatch, 1e-11);
  // contact spreads: pairs close, none opens
  EXPECT_FALSE(path.contacts.front().opening.has_value());
  EXPECT_GT(path.contacts.front().closed.back(), path.contacts.front().closed.front());
  // the arc lies about the direction of the load
  const double towards = std::atan2(3.0, 20.0);
  EXPECT_NEAR(0.5 * (path.contacts.front().from.back() + path.contacts.front().to.back()), towards,
              0.2);
}

TEST(LoadPathSolver, ABodyInAClearanceJumpsWhereItsLoadTurns) {
  // at t = 0.5 all forces are zero and the pin crosses over to the other side
  const std::optional<Solved> solved =
      solve_text_with_raw_K(rings("$CONTACT NAME=FIT SLAVE=PIN.OUTER MASTER=HUB.INNER GAP=0.01\n",
                                  R"($STEP NAME=NONE
  LOAD PULL 0
$STEP NAME=THERE
  LOAD PULL 1
$STEP NAME=BACK
  LOAD PULL -1
$STEP NAME=LITTLE
  LOAD PULL 0.125
$LOADPATH NAME=THROUGH FROM=THERE TO=BACK
$LOADPATH NAME=UP FROM=NONE TO=THERE BEYOND=2
$CRACK NAME=C NET=HUB ANGLE=90[deg] A0=4
  0 20
)"));
  ASSERT_TRUE(solved);
  const results::CrackLengthResult& increment = solved->run.increments.front();
  const results::LoadPathResult& through = increment.paths[0];
  const results::LoadPathFrontPoint& tip = through.fronts.front().single_point();
  EXPECT_TRUE(through.stopped.empty()) << through.stopped;
  EXPECT_LT(through.mismatch, 1e-11);
  EXPECT_NEAR(tip.K[0](0.5), 0.0, 1e-9 * tip.K[0].largest_value());
  ASSERT_FALSE(through.notes.empty());
  EXPECT_NE(through.notes.front().text.find("at t = 0.5 nothing holds a body"), std::string::npos);
  // a pin that rests somewhere until it is loaded
  const results::LoadPathResult& up = increment.paths[1];
  EXPECT_TRUE(up.stopped.empty()) << up.stopped;
  EXPECT_LT(up.mismatch, 1e-11);
  EXPECT_NEAR(up.fronts[0].single_point().K[0](0.125),
              increment.steps[3].fronts[0].single_point().K1, 1e-11 * tip.K[0].largest_value());
}

TEST(LoadPathSolver, ABodyThatComesLooseEndsThePath) {
  const std::optional<Solved> solved = solve_text_with_raw_K(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=LOWER
  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=4 LY=1 NX=4 NY=2
$ENDNET
$NET NAME=UPPER
  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=4 Y0=1 LY=1 NX=3 NY=2
$ENDNET
$MATERIAL NAME=S E=210000 NU=0.3
$PROPERTY ESET=LOWER.BODY MATERIAL=S STATE=STRESS
$PROPERTY ESET=UPPER.BODY MATERIAL=S STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  LOWER.YMIN
$FREEDOM CLASS=SUPPRESSED DOF=X
  UPPER.XMIN
$CONTACT NAME=FACE SLAVE=UPPER.YMIN MASTER=LOWER.YMAX GAP=0
$LOAD CASE=PUSH TYPE=PRESSURE
  UPPER.YMAX 100
$STEP NAME=ALL
  LOAD PUSH 1
$STEP NAME=HALF
  LOAD PUSH 0.5
$LOADPATH NAME=OFF FROM=ALL TO=HALF BEYOND=3
$END
)");
  ASSERT_TRUE(solved);
  const results::LoadPathResult& path = solved->run.increments.front().paths.front();
  EXPECT_NEAR(path.t.back(), 2.0, 1e-9);
  EXPECT_NE(path.stopped.find("body UPPER is loaded but not held"), std::string::npos)
      << path.stopped;
  EXPECT_GT(path.contacts.front().closed.front(), 0);
}

// An edge-cracked block pulled by a factor at the first step and another at the second.
std::string block(double from, double to, const std::string& more) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=20 LY=40 NX=8 NY=16
$MATERIAL NAME=S E=210000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=S STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  YMIN
$LOAD CASE=PULL TYPE=TRACTION
  YMAX 0 100
$STEP NAME=A
  LOAD PULL ({})
$STEP NAME=B
  LOAD PULL ({})
$CRACK NAME=C ANGLE=0 A0=5
  0 20
{}$END
)",
                     from, to, more);
}

TEST(LoadPathSolver, WithoutContactKIsOneLine) {
  const std::optional<Solved> solved =
      solve_text_with_raw_K(block(0.0, 1.0, "$LOADPATH NAME=UP FROM=A TO=B BEYOND=3\n"));
  ASSERT_TRUE(solved);
  const results::LoadPathResult& path = solved->run.increments.front().paths.front();
  EXPECT_EQ(path.t.size(), 2U);
  EXPECT_LT(path.mismatch, 1e-11);
  EXPECT_NEAR(path.fronts[0].single_point().K[0](2.5),
              2.5 * solved->step(1).fronts[0].single_point().K1,
              1e-10 * path.fronts[0].single_point().K[0](2.5));
}

TEST(LoadPathSolver, ClosedCracksHaveNoK1) {
  const auto run = [](const Folder& folder, const std::string& faces) {
    std::string deck = block(1.0, -1.0, R"($LOADPATH NAME=P FROM=A TO=B
$CHECK
  PATH.K1(C,P,0.25) = 1 ABS 1e9
  PATH.K1(C,P,0.75) = 0 ABS 1e-12
  PATH.K1(C,P,1.5) = 1 ABS 1e9
)");
    deck.replace(deck.find("NAME=C "), 7, "NAME=C " + faces + " ");
    EXPECT_EQ(run_text(folder, deck).exit_code, 1); // the last has no value
    return test::slurp(folder.path() / "out" / "listing.txt");
  };
  const Folder free;
  const std::string overlapping = run(free, "FACES=FREE");
  EXPECT_NE(overlapping.find("C: K1 is negative on a part of the path"), std::string::npos);
  EXPECT_NE(overlapping.find("K1 is negative there"), std::string::npos);
  EXPECT_NE(overlapping.find("goes from t = 0 to 1"), std::string::npos);
  EXPECT_NE(overlapping.find("1 of 3 passed"), std::string::npos);
  EXPECT_EQ(test::column(free.path() / "out" / "load_path.csv", "t"),
            std::vector<double>({0.0, 1.0}));
  const Folder contact;
  const std::string closed = run(contact, "");
  EXPECT_NE(closed.find("C: the crack faces touch at the tip on a part of the path"),
            std::string::npos);
  EXPECT_NE(closed.find("2 of 3 passed"), std::string::npos);
  const std::vector<double> t = test::column(contact.path() / "out" / "load_path.csv", "t");
  ASSERT_GE(t.size(), 3U);
  for (std::size_t k = 1; k + 1 < t.size(); ++k) {
    EXPECT_NEAR(t[k], 0.5, 1e-9);
  }
}

TEST(PiecewiseLinear, FindsItsSegmentsHoweverTheyCrowd) {
  std::vector<double> knot{0.0};
  std::vector<double> value;
  std::vector<double> slope;
  double y = 1.0;
  for (int k = 0; k < 300; ++k) { // from wide to very narrow
    const double width = std::pow(0.93, k);
    value.push_back(y);
    slope.push_back(std::sin(k));
    y += width * slope.back();
    knot.push_back(knot.back() + width);
  }
  const base::PiecewiseLinear f(knot, value, slope);
  for (std::size_t s = 0; s < value.size(); ++s) {
    for (const double part : {0.001, 0.5, 0.999}) {
      const double t = knot[s] + part * (knot[s + 1] - knot[s]);
      EXPECT_NEAR(f(t), value[s] + (t - knot[s]) * slope[s], 1e-13) << s;
    }
    EXPECT_NEAR(f(knot[s]), value[s], 1e-13);
  }
  EXPECT_NEAR(f(knot.back()), y, 1e-12);
  EXPECT_TRUE(std::isnan(f(-1e-9)));
  EXPECT_TRUE(std::isnan(f(knot.back() * 1.001)));
  EXPECT_TRUE(std::isnan(base::PiecewiseLinear()(0.0)));
}

} // namespace
} // namespace spricka::test_load_paths
