// SPDX-License-Identifier: GPL-3.0-or-later
// Cracks in space that the deck's own mesh has already: faces with nodes of their own at the same
// places, the front by its nodes.
#include "shape/solid.hpp"
#include "tests/unit/support/check_text.hpp"
#include "tests/unit/support/run_text.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include <fmt/format.h>

namespace spricka::test_found_crack {
namespace {

constexpr int across = 16; // elements across the strip, of edge 1/16
constexpr int half = 32;   // and on both sides of the crack

// A strip 1 x 1/16 x 4 of HEXEC20 with an edge crack of depth 1/2 in z = 0, between smooth plates;
// mid nodes beside the front at a quarter. `doubled`: the faces have their own nodes.
std::string strip(bool doubled, const std::string& more) {
  using S = shape::Hexec20;
  using Place = std::array<int, 4>; // twice the numbers of the grid, and 1 on the lower face
  std::map<Place, int> number;
  std::string nodes;
  std::string elements;
  std::string front;
  const double h = 1.0 / across;
  for (int i = 0; i < across; ++i) {
    for (int k = -half; k < half; ++k) {
      elements += fmt::format("{}", elements.empty() ? 1 : (i * 2 * half + k + half + 1));
      for (const auto& local : S::coordinates) {
        Place at{2 * i + 1 + static_cast<int>(std::lround(local[0])),
                 1 + static_cast<int>(std::lround(local[1])),
                 2 * k + 1 + static_cast<int>(std::lround(local[2])), 0};
        at[3] = doubled && at[2] == 0 && at[0] < across && k < 0 ? 1 : 0;
        const auto [found, fresh] = number.try_emplace(at, static_cast<int>(number.size()) + 1);
        elements += fmt::format(" {}", found->second);
        if (!fresh) {
          continue;
        }
        double x = 0.5 * at[0];
        double z = 0.5 * at[2];
        const int from = std::abs(at[0] - across);
        if (from + std::abs(at[2]) == 1) { // a quarter of the way from the front
          x = 0.5 * across + 0.25 * (at[0] - across);
          z = 0.25 * at[2];
        }
        nodes += fmt::format("{} {:.15g} {:.15g} {:.15g}\n", found->second, h * x, 0.5 * h * at[1],
                             h * z);
        if (from == 0 && at[2] == 0) {
          front += fmt::format(" {}", found->second);
        }
      }
      elements += "\n";
    }
  }
  return "$DECK VERSION=1 LENGTH=mm FORCE=N\n$COOR DIM=3\n" + nodes +
         "$ELEMENT TYPE=HEXEC20 ESET=BODY\n" + elements +
         fmt::format(R"($MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=SOLID
$NSET NAME=SIDES WHERE=(y < 1e-9 or y > {0} - 1e-9)
$NSET NAME=P1 WHERE=(x > 1 - 1e-9 and z < -2 + 1e-9)
$NSET NAME=P2 WHERE=(x < 1e-9 and z < -2 + 1e-9)
$FSET NAME=TOP WHERE=(z > 2 - 1e-9)
$FSET NAME=FOOT WHERE=(z < -2 + 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=Y
  SIDES
$FREEDOM CLASS=SUPPRESSED DOF=XZ
  P1
$FREEDOM CLASS=SUPPRESSED DOF=Z
  P2
$NSET NAME=FRONT
  {1}
$CRACK NAME=C FRONT=FRONT
$TIPNET CRACK=C PATCH=NO
$LOAD CASE=PULL TYPE=TRACTION
  TOP 0 0 1
  FOOT 0 0 -1
{2}$STEP NAME=S
  LOAD PULL 1
$END
)",
                     h, front, more);
}

// F01: 2.824579 sqrt(pi a) of the strip in plane strain (Bowie's, to 1e-6), on a regular mesh.
TEST(ExistingCrack, HasTheKOfItsStrip) {
  const auto solved = test::solve_text(strip(true, ""));
  ASSERT_TRUE(solved);
  ASSERT_EQ(solved->step().fronts.size(), 1U);
  const results::FrontResult& front = solved->step().fronts[0];
  const double K = 2.824579 * std::sqrt(std::numbers::pi * 0.5);
  ASSERT_EQ(front.points.size(), 2U);
  EXPECT_NEAR(front.a, 0.5, 1e-9);
  for (const results::FrontPointResult& place : front.points) {
    EXPECT_NEAR(place.K1, K, 0.005 * K);
    EXPECT_NEAR(place.K2, 0.0, 1e-6 * K);
    EXPECT_NEAR(place.G, place.G_from_K, 0.005 * place.G);
    EXPECT_NEAR(place.direction.x(), 1.0, 1e-9);
  }
}

// Pressed, its faces bear on each other, and nothing is left of it.
TEST(ExistingCrack, ClosesUnderPressure) {
  std::string text = strip(true, "");
  text.replace(text.find("LOAD PULL 1"), 11, "LOAD PULL -1");
  const auto solved = test::solve_text(text);
  ASSERT_TRUE(solved);
  for (const results::FrontPointResult& place : solved->step().fronts[0].points) {
    EXPECT_TRUE(place.closed);
    EXPECT_EQ(place.K1, 0.0);
  }
  const results::ContactResult* faces = results::find_contact(solved->step(), "C.FACES");
  ASSERT_NE(faces, nullptr);
  EXPECT_NEAR(faces->mean_pressure, 1.0, 0.01);
}

// Its faces touch on purpose: that nothing joins them is no news.
TEST(ExistingCrack, IsNoSeamToBeWarnedOf) {
  const test::Folder folder;
  const std::string messages = test::check_text(folder, strip(true, "")).outcome.messages;
  EXPECT_EQ(messages.find("W341"), std::string::npos) << messages;
}

// Nodes that are there once make no crack: told, not solved without one.
TEST(ExistingCrack, IsNotWhereNodesAreNotDoubled) {
  const test::Folder folder;
  const test::Outcome outcome = test::run_text(folder, strip(false, ""));
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_NE(outcome.messages.find("E439"), std::string::npos) << outcome.messages;
}

// A strip 1 x 4 of QUAMC8 of edge 1/20 with a crack in y = 0 from `from` to `to` [edges], by its
// card.
std::string plane_strip(int from, int to, bool doubled, const std::string& crack) {
  constexpr int wide = 20;
  constexpr int high = 40; // above the crack, and below
  using Place = std::array<int, 3>;
  std::map<Place, int> number;
  std::string nodes;
  std::string elements;
  std::string line;
  constexpr std::array<std::array<int, 2>, 8> local{
      {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}}};
  for (int i = 0; i < wide; ++i) {
    for (int k = -high; k < high; ++k) {
      elements += fmt::format("{}", (i * 2 * high) + k + high + 1);
      for (const auto& [right, up] : local) {
        Place at{2 * i + right, 2 * k + up, 0};
        const bool inside = at[0] < 2 * to && (at[0] > 2 * from || from == 0);
        at[2] = doubled && at[1] == 0 && inside && k < 0 ? 1 : 0;
        const auto [found, fresh] = number.try_emplace(at, static_cast<int>(number.size()) + 1);
        elements += fmt::format(" {}", found->second);
        if (fresh) {
          nodes += fmt::format("{} {:.15g} {:.15g}\n", found->second, 0.025 * at[0], 0.025 * at[1]);
        }
      }
      elements += "\n";
    }
  }
  return "$DECK VERSION=1 LENGTH=mm FORCE=N\n$COOR DIM=2\n" + nodes +
         "$ELEMENT TYPE=QUAMC8 ESET=BODY\n" + elements +
         fmt::format(R"($MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN THICK=1
$NSET NAME=P1 WHERE=(x > 1 - 1e-9 and y < -2 + 1e-9)
$NSET NAME=P2 WHERE=(x < 1e-9 and y < -2 + 1e-9)
$FSET NAME=TOP WHERE=(y > 2 - 1e-9)
$FSET NAME=FOOT WHERE=(y < -2 + 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  P1
$FREEDOM CLASS=SUPPRESSED DOF=Y
  P2
$NSET NAME=TIPS
  {0} {1}
$NSET NAME=LINE WHERE=(abs(y) < 1e-9) ORDER=(x)
{2}
$LOAD CASE=PULL TYPE=TRACTION
  TOP 0 1
  FOOT 0 -1
$STEP NAME=S
  LOAD PULL 1
$END
)",
                     number.at({2 * to, 0, 0}), number.at({2 * from, 0, 0}), crack);
}

// In the plane: what the mesh has is what a path of the same nodes is when it is opened.
TEST(ExistingCrack, InThePlaneIsAPathThatIsOpen) {
  const auto found = test::solve_text(plane_strip(0, 10, true, "$CRACK NAME=C FRONT=TIPS"));
  const auto opened = test::solve_text(
      plane_strip(0, 10, false, "$CRACK NAME=C PATH=LINE A0=0.5\n$TIPNET CRACK=C PATCH=NO"));
  ASSERT_TRUE(found && opened);
  ASSERT_EQ(found->step().fronts.size(), 1U);
  const results::FrontPointResult& tip = found->step().fronts[0].points[0];
  const double K = 2.824579 * std::sqrt(std::numbers::pi * 0.5); // as above
  EXPECT_NEAR(tip.K1, opened->step().fronts[0].points[0].K1, 1e-9 * K);
  EXPECT_NEAR(tip.K1, K, 0.005 * K);
  EXPECT_NEAR(found->step().fronts[0].a, 0.5, 1e-12);
}

// Both ends of a crack inside are tips, whether both are named or one.
TEST(ExistingCrack, InsideAPlateHasTwoTips) {
  const double shape =
      (1.0 - 0.025 * 0.16 + 0.06 * 0.0256) / std::sqrt(std::cos(0.2 * std::numbers::pi));
  const double K = shape * std::sqrt(std::numbers::pi * 0.2); // Tada, 0.1 %
  const auto solved = test::solve_text(plane_strip(6, 14, true, "$CRACK NAME=C FRONT=TIPS"));
  ASSERT_TRUE(solved);
  ASSERT_EQ(solved->step().fronts.size(), 2U);
  for (const results::FrontResult& front : solved->step().fronts) {
    EXPECT_NEAR(front.points[0].K1, K, 0.005 * K);
    EXPECT_NEAR(front.points[0].K2, 0.0, 1e-6 * K);
    EXPECT_NEAR(front.a, 0.2, 1e-12);
  }
}

} // namespace
} // namespace spricka::test_found_crack
