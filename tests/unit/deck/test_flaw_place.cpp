// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck_text.hpp"
#include "model/model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace spricka::deck::test_flaw_place {
namespace {

using base::Vec3;

/// A plate of 60 x 120 x 6 with a hole of radius 5 in its middle; `flaw` are the keys of the crack.
std::string plate_with(const std::string& flaw, const std::string& type = "HEXEC20") {
  return "$DECK VERSION=1 LENGTH=mm FORCE=N\n"
         "$NET NAME=PLATE\n"
         "  $MESH SHAPE=PLATE TYPE=" +
         type +
         " RI=5 X0=-30 Y0=-60 LX=60 LY=120 LZ=6 NR=3 NT=24 NZ=2\n"
         "$ENDNET\n"
         "$MATERIAL NAME=M E=70000 NU=0.3\n"
         "$PROPERTY ESET=PLATE.BODY MATERIAL=M STATE=SOLID\n"
         "$FREEDOM CLASS=SUPPRESSED DOF=XYZ\n  PLATE.YMIN\n"
         "$LOAD CASE=P TYPE=TRACTION\n  PLATE.YMAX 0 1 0\n"
         "$STEP NAME=S\n  LOAD P 1\n"
         "$CRACK NAME=C1 NET=PLATE " +
         flaw + "\n$END\n";
}

model::PlanarCrack plane_of(const std::string& deck) {
  const Folder folder;
  const Reading reading(folder, deck);
  EXPECT_TRUE(reading.model) << reading.messages();
  return reading.model ? reading.model->cracks.front().plane : model::PlanarCrack{};
}

void expect_parallel(const Vec3& a, const Vec3& b) {
  EXPECT_NEAR(std::abs(a.dot(b)), 1.0, 1e-9) << a.transpose() << " and " << b.transpose();
}

TEST(FlawPlace, CornerFlawRoundABore) {
  for (const char* type : {"HEXEC20", "TET10", "PENTAC15"}) {
    for (const double degrees : {0.0, 37.0, 90.0, 200.0}) {
      SCOPED_TRACE(testing::Message() << type << ' ' << degrees);
      const model::PlanarCrack plane = plane_of(plate_with(
          "AT=BORE,ZMAX DEPTH=1 LENGTH=2 ANGLE=(" + std::to_string(degrees) + "*pi/180)", type));
      const double angle = degrees * std::numbers::pi / 180.0;
      const Vec3 radial(std::cos(angle), std::sin(angle), 0.0);
      EXPECT_NEAR((plane.place - (5.0 * radial + Vec3(0, 0, 6))).norm(), 0.0, 0.01);
      EXPECT_NEAR(std::abs(plane.normal.dot(radial)), 0.0, 0.01);
      EXPECT_NEAR(plane.along.dot(radial), 1.0, 1e-4);      // into the plate
      EXPECT_NEAR(plane.transverse_axis().z(), -1.0, 1e-9); // angles count into it
      EXPECT_EQ(plane.a, 1.0);
      EXPECT_EQ(plane.c, 2.0);
    }
  }
}

TEST(FlawPlace, CornerFlawOnAStraightEdge) {
  const model::PlanarCrack plane = plane_of(plate_with("AT=PLATE.XMAX,PLATE.ZMIN DEPTH=1.5 Y0=10"));
  EXPECT_NEAR((plane.place - Vec3(30, 10, 0)).norm(), 0.0, 1e-6);
  expect_parallel(plane.normal, Vec3::UnitY());
  EXPECT_NEAR(plane.along.x(), -1.0, 1e-9);
  EXPECT_EQ(plane.c, 1.5);
}

TEST(FlawPlace, SurfaceFlawInABore) {
  const model::PlanarCrack plane =
      plane_of(plate_with("AT=BORE DEPTH=1 LENGTH=3 ANGLE=45[deg] Z0=2"));
  EXPECT_NEAR((plane.place - Vec3(5.0 * std::sqrt(0.5), 5.0 * std::sqrt(0.5), 2)).norm(), 0.0,
              2e-3);
  expect_parallel(plane.along, Vec3::UnitZ());
  expect_parallel(plane.normal, Vec3(1, -1, 0).normalized());
  EXPECT_GT(plane.transverse_axis().x(), 0.7); // into the plate
  EXPECT_EQ(plane.a, 1.0);
  EXPECT_EQ(plane.c, 1.5);
}

TEST(FlawPlace, SurfaceFlawOnAFlatFace) {
  const model::PlanarCrack plane = plane_of(plate_with("AT=ZMAX DEPTH=1 ALONG=X X0=15 Y0=-20"));
  EXPECT_NEAR((plane.place - Vec3(15, -20, 6)).norm(), 0.0, 1e-9);
  expect_parallel(plane.along, Vec3::UnitX());
  expect_parallel(plane.normal, Vec3::UnitY());
  EXPECT_EQ(plane.c, 1.0);
}

TEST(FlawPlace, WhatDoesNotPlaceAFlawIsRefused) {
  const std::pair<const char*, const char*> cases[] = {
      {"AT=BORE,XMAX DEPTH=1 ANGLE=0", "do not meet in an edge"},
      {"AT=BORE,ZMAX DEPTH=1",
       "where on the edge of PLATE.BORE and PLATE.ZMAX the flaw lies is not said"},
      {"AT=XMAX,ZMAX DEPTH=1 ANGLE=0", "is no circle"},
      {"AT=BORE,ZMAX DEPTH=1 ANGLE=0 X0=5", "both say where"},
      {"AT=BORE,ZMAX DEPTH=1 ANGLE=0 ALONG=X", "means nothing there"},
      {"AT=XMAX,ZMAX DEPTH=1 Y0=90", "does not go there"},
      {"AT=BORE DEPTH=1", "where round PLATE.BORE the flaw lies is not said"},
      {"AT=BORE DEPTH=1 ANGLE=0 Z0=9", "does not go there"},
      {"AT=ZMAX DEPTH=1", "needs ALONG"},
      {"AT=ZMAX DEPTH=1 ALONG=Z X0=15", "runs into"},
      {"AT=ZMAX DEPTH=1 ALONG=X", "lies beside"}, // its middle is the hole
      {"AT=ZMAX DEPTH=1 ALONG=X ANGLE=0", "is flat"},
      {"AT=BORE,ZMAX,XMAX DEPTH=1", "one face, or two"},
      {"AT=BOR,ZMAX DEPTH=1 ANGLE=0", "BORE"},
      {"AT=BORE ANGLE=0", "DEPTH"},
      {"A=1 X0=5 Y0=0 Z0=6 NORMAL=Y DEPTH=1", "AT"},
  };
  for (const auto& [flaw, words] : cases) {
    SCOPED_TRACE(flaw);
    const Folder folder;
    const Reading reading(folder, plate_with(flaw));
    EXPECT_FALSE(reading.model);
    EXPECT_NE(reading.messages().find(words), std::string::npos) << reading.messages();
  }
}

/// The same plate in the plane.
std::string plane_plate_with(const std::string& flaw, const std::string& type = "QUAMC8") {
  std::string text = plate_with(flaw, type);
  const auto take = [&](const std::string& what, const std::string& instead) {
    text.replace(text.find(what), what.size(), instead);
  };
  take(" LZ=6", "");
  take(" NZ=2", "");
  take("STATE=SOLID", "STATE=STRESS THICK=6");
  take("DOF=XYZ", "DOF=XY");
  take("0 1 0", "0 1");
  return text;
}

TEST(FlawPlace, InThePlaneAFlawLeavesAnEdgeAtRightAngles) {
  for (const char* type : {"QUAMC8", "TRIM3"}) {
    const Folder folder;
    const Reading bore(folder, plane_plate_with("AT=BORE DEPTH=2 ANGLE=(33*pi/180)", type));
    ASSERT_TRUE(bore.model) << bore.messages();
    const std::vector<Vec3>& points = bore.model->cracks.front().points;
    const double angle = 33.0 * std::numbers::pi / 180.0;
    const Vec3 out(std::cos(angle), std::sin(angle), 0.0);
    ASSERT_EQ(points.size(), 2U);
    EXPECT_NEAR((points[0] - 5.0 * out).norm(), 0.0, 0.05); // facets of 5 (1 - cos 7.5 deg)
    EXPECT_NEAR((points[1] - points[0] - 2.0 * out).norm(), 0.0, 2e-3);
  }
  const Folder folder;
  const Reading side(folder, plane_plate_with("AT=XMAX DEPTH=3 Y0=12.5"));
  ASSERT_TRUE(side.model) << side.messages();
  EXPECT_NEAR((side.model->cracks.front().points[0] - Vec3(30.0, 12.5, 0.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((side.model->cracks.front().points[1] - Vec3(27.0, 12.5, 0.0)).norm(), 0.0, 1e-9);
}

TEST(FlawPlace, WhatDoesNotPlaceAFlawInThePlaneIsRefused) {
  const std::pair<const char*, const char*> cases[] = {
      {"AT=BORE DEPTH=1", "where on PLATE.BORE the flaw lies is not said"},
      {"AT=BORE DEPTH=1 LENGTH=2 ANGLE=0", "LENGTH means nothing in the plane"},
      {"AT=BORE,XMAX DEPTH=1 ANGLE=0", "one edge of the body"},
      {"AT=XMAX DEPTH=1 ANGLE=0", "is no circle"},
      {"AT=XMAX DEPTH=1 Y0=70", "does not go there"},
  };
  for (const auto& [flaw, words] : cases) {
    SCOPED_TRACE(flaw);
    const Folder folder;
    const Reading reading(folder, plane_plate_with(flaw));
    EXPECT_FALSE(reading.model);
    EXPECT_NE(reading.messages().find(words), std::string::npos) << reading.messages();
  }
}

} // namespace
} // namespace spricka::deck::test_flaw_place
