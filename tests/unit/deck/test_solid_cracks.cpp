// SPDX-License-Identifier: GPL-3.0-or-later
// $CRACK in space: what its keys and points mean, and mistakes in them.
#include "deck_text.hpp"
#include "model/model.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace spricka::deck::test_solid_cracks {
namespace {

using base::Vec3;

std::string solid_deck(const std::string& cards) {
  return "$DECK VERSION=1 LENGTH=mm FORCE=N\n$NET NAME=A\n$MESH SHAPE=BLOCK TYPE=HEXE8 LX=4 LY=4 "
         "LZ=4 NX=1 NY=1 NZ=1\n$ENDNET\n$MATERIAL NAME=M E=1000 NU=0.3\n"
         "$PROPERTY ESET=A.BODY MATERIAL=M STATE=SOLID\n" +
         cards + "$END\n";
}

TEST(SolidCrack, AnEllipseHasAxesByItsNormal) {
  const Folder folder;
  const Reading r(folder, solid_deck("$CRACK NAME=C NET=A A=1 C=0.5 X0=1 Y0=2 Z0=3 NORMAL=Y\n"));
  ASSERT_TRUE(r.model) << r.messages();
  const model::CrackDefinition& crack = r.model->cracks.front();
  EXPECT_EQ(crack.kind, model::CrackDefinitionKind::ellipse);
  EXPECT_EQ(crack.plane.place, Vec3(1, 2, 3));
  EXPECT_EQ(crack.plane.normal, Vec3::UnitY());
  EXPECT_EQ(crack.plane.along, Vec3::UnitZ());
  EXPECT_EQ(crack.plane.transverse_axis(), Vec3::UnitX());
  EXPECT_EQ(crack.plane.a, 1.0);
  EXPECT_EQ(crack.plane.c, 0.5);
}

TEST(SolidCrack, AnyPlaneByTwoPoints) {
  const Folder folder;
  const Reading r(folder,
                  solid_deck("$CRACK NAME=C NET=A A=1 X0=1 Y0=0 Z0=0 X1=1 Y1=3 Z1=4 X2=1 Y2=4 "
                             "Z2=7\n"));
  ASSERT_TRUE(r.model) << r.messages();
  const model::PlanarCrack& plane = r.model->cracks.front().plane;
  EXPECT_LT((plane.normal - Vec3(0, 0.6, 0.8)).norm(), 1e-15);
  EXPECT_LT((plane.along - Vec3(0, -0.8, 0.6)).norm(), 1e-14);
  EXPECT_EQ(plane.c, 1.0); // a circle
}

TEST(SolidCrack, AFrontLiesInThePlaneOfItsPoints) {
  const Folder folder;
  const Reading r(folder,
                  solid_deck("$CRACK NAME=C NET=A X0=0.1 Y0=1 Z0=1\n 1 1 0\n 1 2 2\n 1 1 4\n"));
  EXPECT_EQ(r.codes(), "E115") << r.messages(); // the place is beside their plane
  const Reading good(folder, solid_deck("$CRACK NAME=C NET=A X0=0.1 Y0=1 Z0=1\n 1 1 0\n 1.5 1 2\n"
                                        " 1 1 4\n"));
  ASSERT_TRUE(good.model) << good.messages();
  const model::CrackDefinition& crack = good.model->cracks.front();
  EXPECT_EQ(crack.kind, model::CrackDefinitionKind::drawn);
  EXPECT_NEAR(std::abs(crack.plane.normal.y()), 1.0, 1e-12);
  EXPECT_EQ(crack.points.size(), 3U);
}

TEST(SolidCrack, MistakesAreNamed) {
  const Folder folder;
  const auto codes = [&](const std::string& card) {
    return Reading(folder, solid_deck(card)).codes();
  };
  EXPECT_EQ(codes("$CRACK NAME=C NET=A A=1 X0=0 Y0=0 Z0=0\n"), "E106");           // no normal
  EXPECT_EQ(codes("$CRACK NAME=C NET=A A=1 X0=0 Y0=0 NORMAL=Z\n"), "E106");       // no Z0
  EXPECT_EQ(codes("$CRACK NAME=C NET=A A=-1 X0=0 Y0=0 Z0=0 NORMAL=Z\n"), "E109"); // below 0
  EXPECT_EQ(codes("$CRACK NAME=C NET=A A=1 X0=0 Y0=0 Z0=0 NORMAL=Z X2=0 Y2=0 Z2=1\n"), "E109");
  EXPECT_EQ(codes("$CRACK NAME=C NET=A A=1 X0=0 Y0=0 Z0=0 X1=0 Y1=0 Z1=0\n"), "E109");
  EXPECT_EQ(codes("$CRACK NAME=C NET=A A=1 X0=0 Y0=0 Z0=0 NORMAL=Z\n 1 1 1\n"), "E110");
  EXPECT_EQ(codes("$CRACK NAME=C NET=A\n 0 0 1\n 0 4 1\n"), "E106"); // which side?
  EXPECT_EQ(codes("$CRACK NAME=C NET=A X0=0 Y0=2 Z0=1\n 0 0 1\n 0 4 1\n"),
            "E115"); // on its own front
  EXPECT_EQ(codes("$CRACK NAME=C NET=A CLOSED=YES\n 0 0 1\n 0 4 1\n 1 1 1\n"), "E115");
  EXPECT_EQ(codes("$CRACK NAME=C NET=A X0=1 Y0=1 Z0=1\n 0 0\n 0 4 1\n"), "E115");
  EXPECT_EQ(codes("$CRACK NAME=C NET=A\n"), "E106");
}

TEST(SolidCrack, WordsOfTheOtherDimension) {
  const Folder folder;
  const std::string penny = "$CRACK NAME=C NET=A A=1 X0=2 Y0=2 Z0=2 NORMAL=Z\n$LOAD CASE=P "
                            "TYPE=TRACTION\n A.ZMAX 0 0 1\n$STEP NAME=S\n LOAD P 1\n$CHECK\n ";
  const auto codes = [&](const std::string& check) {
    return Reading(folder, solid_deck(penny + check + " = 1 REL 1e-2\n")).codes();
  };
  EXPECT_EQ(codes("K1(C,S)"), "E313");
  EXPECT_EQ(codes("K1.BAR(C,S)"), "E313");
  EXPECT_EQ(codes("K3.MAX(C,S)"), "");
  EXPECT_EQ(codes("K1.AT(C,1,2,3,S)"), "");
  EXPECT_EQ(codes("G.PHI(C,S,45[deg])"), "");
  EXPECT_EQ(Reading(folder, k_square + "$CRACK NAME=C A=1 X0=0 Y0=0 Z0=0 NORMAL=Z\n$END\n").codes(),
            "E313");
}

} // namespace
} // namespace spricka::deck::test_solid_cracks
