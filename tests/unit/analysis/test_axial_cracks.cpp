// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/assemble.hpp"
#include "model/model.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

// Cracks in bodies about an axis: cones and rings in a bar, against energies, motions, differences.
// What the decks check (D05, D06, D09, pennies) is not repeated here.
namespace spricka::test_axial_cracks {
namespace {

using results::FrontPointResult;
using test::solve_text;
using test::Solved;

constexpr double E = 210e3;
constexpr double nu = 0.3;
constexpr double E_effective = E / (1.0 - nu * nu);

// A bar of radius 10 with a crack from its surface inwards that rises towards the axis: K1 and K2.
struct TornadoBar {
  double a = 3.0;
  double rise = 20.0;  ///< degrees
  double height = 0.0; ///< of the mouth
  double unit = 1.0;   ///< all lengths are so many times as large, and forces per area the same
  std::string steps = "$STEP NAME=S\n  LOAD PULL 1\n";
  std::string more = {};

  [[nodiscard]] double radius() const {
    return 10.0 - a * std::cos(rise * std::numbers::pi / 180.0);
  }
  [[nodiscard]] std::string text() const {
    return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$PARAMETER
  u = {}
  h = {}
$MESH SHAPE=BLOCK TYPE=QUAMC8 Y0=((h-30)*u) LX=(10*u) LY=(60*u) NX=8 NY=40
$NSET NAME=FOOT WHERE=(x < 1e-9*u and y < (h-30+1e-6)*u)
$MATERIAL NAME=M E={} NU={} ALPHA=1.2e-5
$PROPERTY ESET=BODY MATERIAL=M STATE=AXI
$FREEDOM CLASS=SUPPRESSED DOF=Y
  FOOT
$CRACK NAME=C A0=({:.17g}*u) ANGLE={}[deg]
  (10*u)  (h*u)
{}
$LOAD CASE=PULL TYPE=TRACTION
  YMAX  0  100
  YMIN  0  -100
$LOAD CASE=FACES TYPE=FACES
  C  (50*(1+x/u/10))
$LOAD CASE=SPIN TYPE=BODY
  BODY  (0.5*x/u^2)  (1e-3*y/u^2)
$LOAD CASE=HEAT TYPE=TEMPERATURE
  BODY  (-40*(x/u/10)^2+3*(y/u-h))
$LOAD CASE=STEEP TYPE=TEMPERATURE
  BODY  (30*(y/u-h))
{}$END
)",
                       unit, height, E, nu, a, 180.0 + rise, more, steps);
  }
};

const FrontPointResult& tip(const std::optional<Solved>& solved, std::size_t step = 0) {
  return solved->step(step).fronts.at(0).single_point();
}

double size_of(const FrontPointResult& K) {
  return std::hypot(K.K1, K.K2);
}

// What G of the mesh is compared with.
double raw_size_of(const FrontPointResult& K) {
  return std::hypot(K.raw_K()[0], K.raw_K()[1]);
}

constexpr const char* each = R"($STEP NAME=PULL
  LOAD PULL 1
$STEP NAME=FACES
  LOAD PULL 0
  LOAD FACES 1
$STEP NAME=SPIN
  LOAD FACES 1
  LOAD SPIN 1
$STEP NAME=HEAT
  LOAD SPIN 0
  LOAD FACES 0
  LOAD HEAT 1
  LOAD PULL 1
)";

// Under loads the potential is less the energy, which each crack length has as a whole.
TEST(AxialCracks, ReleaseWhatTheEnergyLoses) {
  const double h = 0.05;
  TornadoBar bar;
  bar.steps = each;
  const auto at = solve_text(bar.text());
  bar.a += h;
  const auto longer = solve_text(bar.text());
  bar.a -= 2.0 * h;
  const auto shorter = solve_text(bar.text());
  ASSERT_TRUE(at && longer && shorter);
  const double front = 2.0 * std::numbers::pi * TornadoBar().radius();
  for (std::size_t s = 0; s < 3; ++s) {
    const double lost = (longer->step(s).energy - shorter->step(s).energy) / (2.0 * h) / front;
    EXPECT_NEAR(tip(at, s).G, lost, 2e-3 * lost) << at->step(s).step;
  }
}

// Two ways to K: the displacements with themselves, and with the near-tip fields. Domains of two to
// five rings agree.
TEST(AxialCracks, GAndKTellTheSameInAllDomains) {
  for (const double rise : {-60.0, 0.0, 20.0, 60.0}) {
    TornadoBar bar;
    bar.rise = rise;
    bar.steps = each;
    const auto solved = solve_text(bar.text());
    ASSERT_TRUE(solved);
    for (std::size_t s = 0; s < 4; ++s) {
      const FrontPointResult& K = tip(solved, s);
      EXPECT_NEAR(raw_size_of(K) * raw_size_of(K) / E_effective, K.G, 2e-4 * K.G)
          << rise << " " << s;
      EXPECT_LT(K.spread, 1.5e-4) << rise << " " << s;
    }
  }
}

TEST(AxialCracks, DoNotCareForPlaceAndUnit) {
  TornadoBar bar;
  bar.steps = each;
  const auto at = solve_text(bar.text());
  bar.height = 7.3;
  // Of SPIN one component knows where the axis begins, and the part of the body that it pulls.
  const auto moved = solve_text(bar.text());
  bar = TornadoBar();
  bar.steps = each;
  bar.unit = 1000.0;
  const auto large = solve_text(bar.text());
  ASSERT_TRUE(at && moved && large);
  for (const std::size_t s : {std::size_t{0}, std::size_t{1}, std::size_t{3}}) {
    const double K = size_of(tip(at, s));
    EXPECT_NEAR(tip(moved, s).K1, tip(at, s).K1, 1e-9 * K);
    EXPECT_NEAR(tip(moved, s).K2, tip(at, s).K2, 1e-9 * K);
  }
  for (std::size_t s = 0; s < 4; ++s) {
    const double K = size_of(tip(at, s));
    EXPECT_NEAR(tip(large, s).K1 / std::sqrt(1000.0), tip(at, s).K1, 1e-9 * K);
    EXPECT_NEAR(tip(large, s).K2 / std::sqrt(1000.0), tip(at, s).K2, 1e-9 * K);
    EXPECT_NEAR(tip(large, s).T, tip(at, s).T, 1e-8 * std::abs(tip(at, s).T));
  }
}

// K of the finite shift takes its size from the energy of moved nodes, with all loads.
TEST(AxialCracks, MovedNodesReleaseTheSame) {
  TornadoBar bar;
  bar.steps = each;
  const auto analytic = solve_text(bar.text());
  bar.more = "$VCE CRACK=C SHIFT=1e-3 CHECK=OPENING";
  const auto shifted = solve_text(bar.text());
  ASSERT_TRUE(analytic && shifted);
  for (std::size_t s = 0; s < 4; ++s) {
    EXPECT_NEAR(tip(shifted, s).G, tip(analytic, s).G, 1e-5 * tip(analytic, s).G);
    ASSERT_TRUE(tip(shifted, s).opening);
    EXPECT_NEAR((*tip(shifted, s).opening)[0], tip(analytic, s).K1,
                0.02 * size_of(tip(analytic, s)));
    EXPECT_NEAR((*tip(shifted, s).opening)[1], tip(analytic, s).K2,
                0.02 * size_of(tip(analytic, s)));
  }
}

// A temperature that is linear along the axis strains the whole body without stress.
TEST(AxialCracks, HaveNoKWhereHeatLeavesNoStress) {
  TornadoBar bar;
  bar.steps = "$STEP NAME=PULL\n  LOAD PULL 1\n$STEP NAME=BOTH\n  LOAD STEEP 1\n";
  const auto solved = solve_text(bar.text());
  ASSERT_TRUE(solved);
  const double K = size_of(tip(solved, 0));
  EXPECT_NEAR(tip(solved, 1).K1, tip(solved, 0).K1, 2e-3 * K);
  EXPECT_NEAR(tip(solved, 1).K2, tip(solved, 0).K2, 2e-3 * K);
  EXPECT_NEAR(tip(solved, 1).T, tip(solved, 0).T, 1.0);
}

double by(const std::optional<Solved>& solved, results::SensitivityParameter cause,
          const std::string& name, std::size_t mode) {
  for (const results::Sensitivity& s : solved->step().fronts.at(0).sensitivities.by_parameter) {
    if (s.cause == cause && s.name == name && s.is_smooth()) {
      return s.below.at(0)[mode];
    }
  }
  ADD_FAILURE() << "no derivative by " << name;
  return 0.0;
}

TEST(AxialCracks, DerivativesAreDifferences) {
  const double h = 0.02;
  TornadoBar bar;
  bar.steps = "$STEP NAME=S\n  LOAD PULL 1\n  LOAD FACES 1\n  LOAD SPIN 1\n  LOAD HEAT 1\n";
  const auto at = solve_text(bar.text());
  bar.a += h;
  const auto longer = solve_text(bar.text());
  bar.a -= 2.0 * h;
  const auto shorter = solve_text(bar.text());
  ASSERT_TRUE(at && longer && shorter);
  const base::Vec2 slope =
      base::Vec2(tip(longer).K1 - tip(shorter).K1, tip(longer).K2 - tip(shorter).K2) / (2.0 * h);
  const base::Vec2 found(by(at, results::SensitivityParameter::length, "C", 0),
                         by(at, results::SensitivityParameter::length, "C", 1));
  EXPECT_LT((found - slope).norm(), 2e-3 * slope.norm())
      << found.transpose() << " against " << slope.transpose();
  base::Vec2 sum = base::Vec2::Zero();
  for (const char* load : {"PULL", "FACES", "SPIN", "HEAT"}) {
    for (const std::size_t mode : {std::size_t{0}, std::size_t{1}}) {
      sum[static_cast<Eigen::Index>(mode)] +=
          by(at, results::SensitivityParameter::load, load, mode);
    }
  }
  // K of the mesh is linear in the loads, rows and constants together.
  EXPECT_NEAR(sum.x(), tip(at).raw_K()[0], 1e-9 * size_of(tip(at)));
  EXPECT_NEAR(sum.y(), tip(at).raw_K()[1], 1e-9 * size_of(tip(at)));
}

// A ring pressed on a tube with a crack from the bore under the ring, or in the fit beside its
// middle.
struct PressFit {
  double a = 2.0;
  bool in_bore = true;

  [[nodiscard]] double radius() const { return in_bore ? 10.0 + a : 20.0 - a; }
  [[nodiscard]] std::string text() const {
    return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=TUBE
  $MESH SHAPE=BLOCK TYPE=QUAMC8 X0=10 Y0=-40 LX=10 LY=80 NX=6 NY=48
$ENDNET
$NET NAME=RING
  $MESH SHAPE=BLOCK TYPE=QUAMC8 X0=20 Y0=-5 LX=10 LY=10 NX=7 NY=8
$ENDNET
$MATERIAL NAME=STEEL E=210e3 NU=0.3
$MATERIAL NAME=ALU E=70e3 NU=0.33
$PROPERTY ESET=TUBE.BODY MATERIAL=STEEL STATE=AXI
$PROPERTY ESET=RING.BODY MATERIAL=ALU STATE=AXI
$FREEDOM CLASS=SUPPRESSED DOF=Y
  TUBE.YMIN  RING.YMIN
$CONTACT NAME=FIT SLAVE=RING.XMIN MASTER=TUBE.XMAX INTERFERENCE=0.04
$CRACK NAME=C NET=TUBE A0={:.17g} ANGLE={}[deg]
  {}
$LOAD CASE=PULL TYPE=TRACTION
  TUBE.YMAX  0  300
$STEP NAME=FIT
  FIT FIT 1
$STEP NAME=PULL
  LOAD PULL 1
$END
)",
                       a, in_bore ? 0 : 180, in_bore ? "10  0.5" : "20  1");
  }
};

double potential(const Solved& solved, std::size_t step) {
  const base::Vector load =
      fe::consistent_load_vector(solved.model, solved.mesh(), solved.model.cases.at(0));
  return solved.step(step).energy -
         (step == 0 ? 0.0 : load.dot(solved.step(step).u)); // the fit itself bears no load
}

// The fit bends the tube and opens a crack in its bore; the pull opens one whose mouth lies on the
// fit.
TEST(AxialCracks, ReleaseWhatAPressFitLoses) {
  const double h = 0.1;
  for (const bool in_bore : {true, false}) {
    PressFit fit{.a = 2.0, .in_bore = in_bore};
    const auto at = solve_text(fit.text());
    fit.a += h;
    const auto longer = solve_text(fit.text());
    fit.a -= 2.0 * h;
    const auto shorter = solve_text(fit.text());
    ASSERT_TRUE(at && longer && shorter);
    fit.a += h;
    for (const std::size_t s : {std::size_t{0}, std::size_t{1}}) {
      if (tip(at, s).closed) {
        EXPECT_TRUE(!in_bore && s == 0); // the tube is bent inwards
        continue;
      }
      const double lost = (potential(*shorter, s) - potential(*longer, s)) / (2.0 * h) /
                          (2.0 * std::numbers::pi * fit.radius());
      EXPECT_NEAR(tip(at, s).G, lost, 0.01 * lost) << in_bore << " " << s;
      const double K = raw_size_of(tip(at, s));
      EXPECT_NEAR(K * K / E_effective, tip(at, s).G, 2e-4 * tip(at, s).G);
    }
    EXPECT_GT(tip(at, 1).K1, 100.0);
  }
}

// The whole of a bar and the half above the plane of the crack.
TEST(AxialCracks, HalfTellsWhatTheWholeTells) {
  const auto deck = [](bool half) {
    return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 Y0={} LX=10 LY={} NX=10 NY={}
$NSET NAME=LINE WHERE=({}) ORDER=(x)
$MATERIAL NAME=M E=210e3 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=AXI
$FREEDOM CLASS=SUPPRESSED DOF=Y
  LINE
$CRACK NAME=C {}
$LOAD CASE=PULL TYPE=TRACTION
  YMAX  0  100
{}$STEP NAME=S
  LOAD PULL 1
$END
)",
                       half ? 0 : -30, half ? 30 : 60, half ? 30 : 60,
                       half ? "abs(y) < 1e-9" : "x < 1e-9 and y < 1e-9-30",
                       half ? "PATH=LINE A0=4" : "\n  0 0\n  4 0", half ? "" : "  YMIN 0 -100\n");
  };
  const auto whole = solve_text(deck(false));
  const auto half = solve_text(deck(true));
  ASSERT_TRUE(whole && half);
  EXPECT_NEAR(tip(half).K1, tip(whole).K1, 3e-4 * tip(whole).K1);
  EXPECT_NEAR(tip(half).G, tip(whole).G, 6e-4 * tip(whole).G);
  EXPECT_NEAR(tip(half).T, tip(whole).T, 0.01 * std::abs(tip(whole).T));
}

// Under pressure from all sides a body with a closed crack is the one without.
TEST(AxialCracks, ClosedFacesCarryPressure) {
  TornadoBar bar;
  bar.rise = 30.0;
  bar.steps = "$LOAD CASE=ROUND TYPE=PRESSURE\n  XMAX 70\n  YMIN 70\n  YMAX 70\n"
              "$STEP NAME=S\n  LOAD ROUND 1\n";
  const auto solved = solve_text(bar.text());
  ASSERT_TRUE(solved);
  EXPECT_EQ(tip(solved).K1, 0.0);
  EXPECT_NEAR(tip(solved).K2, 0.0, 1e-8 * 70.0);
  for (const results::ContactPoint& point : solved->step().contacts.at(0).points) {
    EXPECT_NEAR(point.p_lumped, 70.0, 1e-6 * 70.0);
  }
}

} // namespace
} // namespace spricka::test_axial_cracks
