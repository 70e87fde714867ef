// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck_text.hpp"

#include <gtest/gtest.h>

// A forgotten THICK is 1, and a plane answer shows nothing of it: it is asked for or said.
namespace spricka::deck::test_thickness {
namespace {

std::string block(const std::string& name, double y) {
  return "$NET NAME=" + name +
         "\n$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=4 LY=2 NX=4 NY=2 Y0=" + std::to_string(y) +
         "\n$ENDNET\n";
}

std::string two_bodies(const std::string& low, const std::string& top, const std::string& more) {
  return "$DECK VERSION=1 LENGTH=mm FORCE=N\n" + block("LOW", 0.0) + block("TOP", 2.0) +
         "$MATERIAL NAME=M E=1000 NU=0.3\n$PROPERTY ESET=LOW.BODY MATERIAL=M STATE=" + low +
         "\n$PROPERTY ESET=TOP.BODY MATERIAL=M STATE=" + top + "\n" + more + "$END\n";
}

const std::string contact = "$CONTACT NAME=SEAM SLAVE=TOP.YMIN MASTER=LOW.YMAX\n";
const std::string pressure = "$LOAD CASE=L TYPE=PRESSURE\n TOP.YMAX 1\n";
const std::string force = "$LOAD CASE=L TYPE=RESULTANT\n TOP.BODY 0 -1\n";

std::string warnings(const Reading& r) {
  std::string codes;
  for (const base::Diagnostic& d : r.diagnostics.messages()) {
    codes += (codes.empty() ? "" : " ") + d.code;
  }
  return codes;
}

TEST(Thickness, OneOfSeveralCannotBeForgotten) {
  const Folder folder;
  EXPECT_EQ(Reading(folder, two_bodies("STRESS THICK=12", "STRESS", contact)).codes(), "E432");
  EXPECT_EQ(Reading(folder, two_bodies("STRAIN", "STRAIN THICK=12", "")).codes(), "E432");
  EXPECT_EQ(warnings(Reading(folder, two_bodies("STRESS", "STRESS", contact + pressure))), "");
  EXPECT_EQ(
      warnings(Reading(folder, two_bodies("STRESS THICK=3", "STRESS THICK=3", contact + force))),
      "");
}

TEST(Thickness, ForcesWantIt) {
  const Folder folder;
  EXPECT_EQ(warnings(Reading(folder, two_bodies("STRESS", "STRESS", force))), "W432");
  const std::string text = k_square + "$NSET NAME=A\n 1 4\n$LOAD CASE=L TYPE=FORCE\n A 1 0\n$END\n";
  EXPECT_EQ(warnings(Reading(folder, text)), "W432");
}

TEST(Thickness, BodiesThatMeetAreAlikeOrItIsSaid) {
  const Folder folder;
  const auto of = [&](const std::string& low, const std::string& top, const std::string& more) {
    const Reading r(folder, two_bodies(low, top, more));
    EXPECT_TRUE(r.model) << r.messages();
    return warnings(r);
  };
  const std::string tie = "$MPC TYPE=TRANSITION SLAVE=TOP.YMIN MASTER=LOW.YMAX\n";
  EXPECT_EQ(of("STRESS THICK=12", "STRESS THICK=10", contact), "W433");
  EXPECT_EQ(of("STRESS THICK=12", "STRESS THICK=10", tie), "W433");
  EXPECT_EQ(of("STRESS THICK=12", "STRESS THICK=10", ""), ""); // they do not meet
  EXPECT_EQ(of("STRESS THICK=12", "STRAIN THICK=12", contact), "W434");
  EXPECT_EQ(of("STRESS THICK=12", "STRAIN THICK=10", contact), "W433 W434");
}

TEST(Thickness, PartsOfOneBodyAreNeighboursToo) {
  const Folder folder;
  const auto of = [&](const std::string& left, const std::string& right) {
    return warnings(Reading(
        folder, "$DECK VERSION=1 LENGTH=mm FORCE=N\n$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=4 LY=2 NX=4 "
                "NY=2\n$ESET NAME=A WHERE=(x < 2)\n$ESET NAME=B WHERE=(x > 2)\n"
                "$MATERIAL NAME=M E=1000 NU=0.3\n$PROPERTY ESET=A MATERIAL=M STATE=" +
                    left + "\n$PROPERTY ESET=B MATERIAL=M STATE=" + right + "\n$END\n"));
  };
  EXPECT_EQ(of("STRESS THICK=2", "STRESS THICK=2"), "");
  EXPECT_EQ(of("STRESS THICK=2", "STRESS THICK=1"), "W433");
  EXPECT_EQ(of("STRESS THICK=2", "STRAIN THICK=2"), "W434");
}

// Lines of TYPE=DISP for one set add up; at a corner of two sets they must agree.
std::string moved(const std::string& lines) {
  return k_square + "$NSET NAME=A\n 1 2\n$NSET NAME=B\n 2 3\n$NSET NAME=A2\n 1 2\n" +
         "$FREEDOM CLASS=PRESCRIBED DOF=XY\n A B\n$LOAD CASE=C TYPE=DISP\n" + lines + "$END\n";
}

TEST(Displacements, OfOneCaseDoNotContradictEachOther) {
  const Folder folder;
  EXPECT_EQ(Reading(folder, moved(" A 0.1 0\n A 0.2 0\n")).codes(), "");
  EXPECT_EQ(Reading(folder, moved(" A 0.1 0\n A2 0.2 0\n")).codes(), "");
  EXPECT_EQ(Reading(folder, moved(" A 0.1 0\n B 0.1 0\n")).codes(), "");
  EXPECT_EQ(Reading(folder, moved(" A 0.1 0\n B 0 0.2\n")).codes(), "");
  EXPECT_EQ(Reading(folder, moved(" A (0.1*y+0.3*x) 0\n B (0.3*x+0.2*y) 0\n")).codes(), "");
  EXPECT_EQ(Reading(folder, moved(" A 0.1 0\n B 0.2 0\n")).codes(), "E433");
  EXPECT_EQ(Reading(folder, moved(" A 0.1 0\n B 0.2 0\n A 0.1 0\n")).codes(), "");
}

} // namespace
} // namespace spricka::deck::test_thickness
