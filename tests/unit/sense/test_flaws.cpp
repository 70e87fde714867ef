// SPDX-License-Identifier: GPL-3.0-or-later
// What the body has of a crack in space, beside what the deck draws.
#include "sense/find_kink.hpp"
#include "sense/flaws.hpp"
#include "sense/half_model.hpp"
#include "tests/unit/deck/deck_text.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace spricka::test_flaws {
namespace {

using base::Vec3;

struct Told {
  std::string line; ///< of the first crack
  std::string messages;
  [[nodiscard]] bool has(const std::string& part) const {
    return messages.find(part) != std::string::npos;
  }
};

/// A bar along x, 10 wide along y, 6 thick along z, x from -8 to 8, with a crack.
Told bar(const std::string& crack, const std::string& more = "", double thickness = 6.0,
         const std::string& type = "HEXEC20") {
  const deck::Folder folder;
  deck::Reading r(folder,
                  fmt::format("$DECK VERSION=1 LENGTH=mm FORCE=N\n$NET NAME=A\n$MESH SHAPE=BLOCK "
                              "TYPE={} X0=-8 LX=16 LY=10 LZ={} NX=6 NY=5 NZ=3\n$ENDNET\n"
                              "$MATERIAL NAME=M E=70000 NU=0.3\n$PROPERTY ESET=A.BODY MATERIAL=M "
                              "STATE=SOLID\n{}$CRACK NAME=C NET=A {}\n$END\n",
                              type, thickness, more, crack));
  EXPECT_TRUE(r.model) << r.messages();
  if (!r.model) {
    return {};
  }
  sense::reduce_to_half_model(*r.model, r.diagnostics);
  const std::vector<std::string> lines = sense::describe_solid_cracks(*r.model, r.diagnostics);
  return {lines.empty() ? "" : lines.front(), r.messages()};
}

TEST(Flaws, KindAndLengthAlongEachFace) {
  const Told corner = bar("A=1 X0=0 Y0=0 Z0=0 NORMAL=X");
  EXPECT_EQ(corner.line, "crack C: corner crack, 1 mm along A.ZMIN and 1 mm along A.YMIN, area "
                         "0.7854 mm^2, 25 % of the ellipse drawn");
  const Told surface = bar("A=1 C=2 X0=0 Y0=5 Z0=0 NORMAL=X");
  EXPECT_EQ(surface.line, "crack C: surface crack, 4 mm along A.ZMIN, 1 mm deep, area 3.141 mm^2, "
                          "50 % of the ellipse drawn");
  const Told inside = bar("A=1 X0=0 Y0=5 Z0=3 NORMAL=X");
  EXPECT_EQ(inside.line, "crack C: embedded crack, 2 mm from A.ZMIN, area 3.141 mm^2");
  const Told through = bar("X0=0 Y0=1 Z0=3\n 0 4 -1\n 0 4 7");
  EXPECT_EQ(through.line, "crack C: through crack, 4 mm along A.ZMIN, 6 mm along A.YMIN and 4 mm "
                          "along A.ZMAX, area 24 mm^2");
  for (const Told& told : {corner, surface, inside, through}) {
    EXPECT_EQ(told.messages, "") << told.line;
  }
}

// A half chord of the circle at a distance d from its centre: sqrt(a^2 - d^2).
TEST(Flaws, ACentreBesideTheFaceMakesAnotherFlaw) {
  const double a = 1.27;
  for (const double d : {0.1, 0.6, 1.1}) {
    const Told outside = bar(fmt::format("A={} X0=0 Y0=0 Z0={} NORMAL=X", a, -d));
    EXPECT_TRUE(outside.has("W460")) << d << outside.line;
    EXPECT_TRUE(outside.has(
        fmt::format("{:.0f} % of the ellipse's radius outside of A.ZMIN", 100.0 * d / a)))
        << outside.messages;
    EXPECT_TRUE(outside.has(fmt::format("{:.4g} mm along A.ZMIN", std::sqrt(a * a - d * d))))
        << outside.messages;
    const Told within = bar(fmt::format("A={} X0=0 Y0={} Z0={} NORMAL=X", a, d, d));
    EXPECT_TRUE(within.has("W460") && within.has("inside of A.ZMIN") &&
                within.has("inside of A.YMIN"))
        << within.messages;
  }
  EXPECT_FALSE(bar("A=1.27 X0=0 Y0=0 Z0=1e-3 NORMAL=X").has("W460"));
  EXPECT_FALSE(bar("A=1.27 X0=0 Y0=5 Z0=3 NORMAL=X").has("W460"));
}

TEST(Flaws, AnEllipseWiderThanTheBodyIsThick) {
  const Told wide = bar("A=7 X0=0 Y0=0 Z0=0 NORMAL=X");
  EXPECT_TRUE(wide.has("W460") && wide.has("86 % of the ellipse's radius inside of A.ZMAX"))
      << wide.messages;
  EXPECT_TRUE(wide.has(fmt::format("{:.4g} mm along A.ZMAX", std::sqrt(49.0 - 36.0))))
      << wide.messages;
  EXPECT_FALSE(bar("A=5 X0=0 Y0=0 Z0=0 NORMAL=X").has("W460"));
  // Drawn as they are meant: a bowed front about the middle, and one that is nearly straight.
  EXPECT_FALSE(bar("A=6 X0=0 Y0=0 Z0=3 NORMAL=X").has("W460"));
  EXPECT_FALSE(bar("A=60 C=4 X0=0 Y0=0 Z0=1 NORMAL=X").has("W460"))
      << bar("A=60 C=4 X0=0 Y0=0 Z0=1 NORMAL=X").messages;
}

TEST(Flaws, ASurfaceCrackBesideAnEdgeItHasMissed) {
  const std::string at_6 = "A=1.27 X0=0 Y0=0 Z0=6 NORMAL=X";
  EXPECT_EQ(bar(at_6).messages, "");
  const Told thicker = bar(at_6, "", 8.0);
  EXPECT_TRUE(thicker.line.starts_with("crack C: surface crack")) << thicker.line;
  EXPECT_TRUE(thicker.has("W460") && thicker.has("only 0.73 mm from the edge of the body at (0, 0, "
                                                 "8)"))
      << thicker.messages;
  EXPECT_FALSE(bar("A=2.5 X0=0 Y0=0 Z0=3 NORMAL=X").has("W460")); // in the middle of the face
  EXPECT_FALSE(bar("A=1.27 X0=0 Y0=0 Z0=4 NORMAL=X", "", 8.0).has("W460"));
}

TEST(Flaws, ThePointIsOnTheWrongSideOfTheFront) {
  const std::string front = "\n 0 2 -0.1\n 0 1.5 1.3\n 0 -0.1 2";
  EXPECT_FALSE(bar("X0=0 Y0=0.2 Z0=0.2" + front).has("W461"));
  const Told wrong = bar("X0=0 Y0=8 Z0=4" + front);
  EXPECT_TRUE(wrong.has("W461") && wrong.has("% of the section")) << wrong.messages;
  EXPECT_FALSE(bar("X0=0 Y0=1 Z0=3\n 0 7 -1\n 0 7 7").has("W461")); // a deep one, 70 %
}

TEST(Flaws, ACornerCrackOnAPlaneOfSymmetry) {
  const std::string held = "$FREEDOM CLASS=SUPPRESSED DOF=Z\n  A.ZMIN\n";
  const Told half = bar("A=1 X0=0 Y0=0 Z0=0 NORMAL=X", held);
  EXPECT_TRUE(half.has("W462") && half.has("2 mm long on A.YMIN")) << half.messages;
  EXPECT_FALSE(bar("A=1 X0=0 Y0=0 Z0=6 NORMAL=X", held).has("W462"));
  const std::string both = held + "$FREEDOM CLASS=SUPPRESSED DOF=Y\n  A.YMIN\n";
  EXPECT_FALSE(bar("A=1 X0=0 Y0=0 Z0=0 NORMAL=X", both).has("W462")); // a quarter of a penny
  EXPECT_FALSE(bar("A=1 X0=0 Y0=5 Z0=0 NORMAL=X", held).has("W462")); // half of one
}

TEST(Flaws, LinearElementsRoundACrack) {
  const std::string corner = "A=1 X0=0 Y0=0 Z0=0 NORMAL=X";
  EXPECT_TRUE(bar(corner, "", 6.0, "HEXE8").has("W426: crack C"));
  EXPECT_FALSE(bar(corner).has("W426"));
}

std::vector<Vec3> arc(int points, double angle) {
  std::vector<Vec3> x;
  for (int i = 0; i < points; ++i) {
    const double phi = angle * i / (points - 1);
    x.emplace_back(std::cos(phi), std::sin(phi), 0.0);
  }
  return x;
}

TEST(FrontKinks, SmoothFrontsHaveNoneHoweverFewPointsDrawThem) {
  for (int n = 4; n < 30; ++n) {
    EXPECT_FALSE(sense::find_misplaced_front_point(arc(n, std::numbers::pi), false)) << n;
    EXPECT_FALSE(sense::find_misplaced_front_point(arc(n, 0.5 * std::numbers::pi), false)) << n;
    std::vector<Vec3> circle = arc(n + 1, 2.0 * std::numbers::pi);
    circle.pop_back();
    EXPECT_FALSE(sense::find_misplaced_front_point(circle, true)) << n;
    std::vector<Vec3> wave;
    for (int i = 0; i < 4 * n; ++i) {
      const double s = i / (4.0 * n - 1.0);
      wave.emplace_back(s, 0.1 * std::cos(4.0 * std::numbers::pi * s), 0.0);
    }
    EXPECT_FALSE(sense::find_misplaced_front_point(wave, false)) << n;
  }
  // Real corners, with points beside them.
  EXPECT_FALSE(sense::find_misplaced_front_point(
      {{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {1, 2, 0}, {2, 2, 0}}, false));
}

TEST(FrontKinks, AMistypedPointIsFound) {
  for (int n = 6; n < 20; ++n) {
    const std::vector<Vec3> good = arc(n, 0.5 * std::numbers::pi);
    const double apart = (good[1] - good[0]).norm();
    for (int i = 1; i + 1 < n; ++i) {
      std::vector<Vec3> bad = good;
      bad[static_cast<std::size_t>(i)] *= 1.0 + apart; // off by as much as points are apart
      const auto kink = sense::find_misplaced_front_point(bad, false);
      ASSERT_TRUE(kink) << n << ' ' << i;
      EXPECT_EQ(kink->point, static_cast<std::size_t>(i)) << n;
      EXPECT_LT(kink->without, 0.51 * std::numbers::pi);
    }
  }
}

} // namespace
} // namespace spricka::test_flaws
