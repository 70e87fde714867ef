// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck_text.hpp"
#include "model/model.hpp"

#include <algorithm>

#include <gtest/gtest.h>

// What cards ask for together: contradictions are mistakes, analyses that are not there are noted
// with their place, heat that nothing feels is told.
namespace spricka::deck::test_scope {
namespace {

const std::string head = "$DECK VERSION=1 LENGTH=mm FORCE=N\n";

std::string block(const std::string& name, const std::string& more) {
  return "$NET NAME=" + name + "\n$MESH SHAPE=BLOCK " + more + "\n$ENDNET\n";
}
std::string material(const std::string& more = "NU=0.3") {
  return "$MATERIAL NAME=M E=1000 " + more + "\n";
}
std::string property(const std::string& net, const std::string& state) {
  return "$PROPERTY ESET=" + net + ".BODY MATERIAL=M STATE=" + state + "\n";
}
const std::string plane = "TYPE=QUAMC8 LX=4 LY=2 NX=4 NY=2";
const std::string solid = "TYPE=HEXE8 LX=1 LY=1 LZ=1 NX=1 NY=1 NZ=1";
const std::string crack = "$CRACK NAME=C NET=A A0=0.5 ANGLE=90[deg]\n 2 0\n";

std::vector<std::string> notes(const Reading& r) {
  std::vector<std::string> what;
  EXPECT_TRUE(r.model) << r.messages();
  if (r.model) {
    for (const model::UnimplementedAnalysis& u : r.model->unavailable) {
      EXPECT_TRUE(u.span.valid());
      what.push_back(u.what);
    }
  }
  return what;
}

// The square of unit side with supports by `cards`, one of its nodes moved.
std::string moved(const std::string& cards, const std::string& disp, const std::string& state) {
  std::string text = k_square;
  text.replace(text.find("STATE=STRESS"), 12, "STATE=" + state);
  return text + "$NSET NAME=A\n 1 4\n$NSET NAME=B\n 2 3\n" + cards + "$LOAD CASE=C TYPE=DISP\n " +
         disp + "\n$END\n";
}

TEST(ExpressionScope, SuppressedFreedomsCannotBeMoved) {
  const Folder folder;
  const std::string both = "$FREEDOM CLASS=SUPPRESSED DOF=X\n A\n"
                           "$FREEDOM CLASS=PRESCRIBED DOF=XY\n A\n";
  const Reading r(folder, moved(both, "A 1e-3 0", "STRESS"));
  EXPECT_EQ(r.codes(), "E319") << r.messages();
  EXPECT_NE(r.messages().find("node 1 is SUPPRESSED as well and cannot be moved by 0.001 along X"),
            std::string::npos)
      << r.messages();
  // along Y it may move, and by nothing it may be moved anywhere
  EXPECT_EQ(Reading(folder, moved(both, "A 0 1e-3", "STRESS")).codes(), "");
  EXPECT_EQ(Reading(folder, moved(both, "A (x) 1", "STRESS")).codes(), "");
  EXPECT_EQ(Reading(folder, moved(both, "A (y) 1", "STRESS")).codes(), "E319"); // node 4 only
}

TEST(ExpressionScope, NothingLeavesTheAxis) {
  const Folder folder;
  const std::string all = "$FREEDOM CLASS=PRESCRIBED DOF=XY\n A B\n";
  const Reading r(folder, moved(all, "A 1e-3 0", "AXI"));
  EXPECT_EQ(r.codes(), "E319") << r.messages();
  EXPECT_NE(r.messages().find("node 1 lies on the axis"), std::string::npos) << r.messages();
  EXPECT_EQ(Reading(folder, moved(all, "A 0 1e-3", "AXI")).codes(), "");
  EXPECT_EQ(Reading(folder, moved(all, "B 1e-3 0", "AXI")).codes(), "");
  EXPECT_EQ(Reading(folder, moved(all, "A 1e-3 0", "STRAIN")).codes(), ""); // x = 0 is no axis
}

TEST(ExpressionScope, HeatedMaterialsWithoutAlphaAreToldOnce) {
  const Folder folder;
  const auto read = [&](const std::string& alpha, const std::string& loads) {
    const Reading r(folder, head + block("A", plane) + block("B", plane + " Y0=3") +
                                material("NU=0.3 " + alpha) + "$MATERIAL NAME=COLD E=1 NU=0\n" +
                                property("A", "STRESS") +
                                "$PROPERTY ESET=B.BODY MATERIAL=COLD STATE=STRESS\n" + loads +
                                "$END\n");
    EXPECT_TRUE(r.model) << r.messages();
    std::string told;
    for (const base::Diagnostic& d : r.diagnostics.messages()) {
      told += d.code + ": " + d.text + "\n";
    }
    return told;
  };
  const std::string heat = "$LOAD CASE=H TYPE=TEMPERATURE\n A.BODY 10\n A.BODY (x)\n";
  EXPECT_EQ(read("", heat), "W313: material M is heated, but has no ALPHA: it does not expand\n");
  EXPECT_EQ(read("ALPHA=1e-5", heat), "");
  EXPECT_EQ(read("", "$LOAD CASE=H TYPE=BODY\n A.BODY 1 0\n"), "");
}

TEST(ExpressionScope, AMeshAboutAnAxisIsThatAsAWhole) {
  const Folder folder;
  const std::string nets =
      head + block("A", plane) + block("B", plane + " Y0=2") + material() + property("A", "AXI");
  EXPECT_EQ(Reading(folder, nets + property("B", "STRESS") + "$END\n").codes(), "E313");
  EXPECT_EQ(Reading(folder, nets + property("B", "STRAIN") + "$END\n").codes(), "E313");
  EXPECT_EQ(Reading(folder, nets + property("B", "AXI") + "$END\n").codes(), "");
  const auto at = [&](const std::string& x0) {
    return Reading(folder, head + block("A", plane + " X0=" + x0) + material() +
                               property("A", "AXI") + "$END\n")
        .codes();
  };
  EXPECT_EQ(at("-1"), "E313");
  EXPECT_EQ(at("0"), "");
  EXPECT_EQ(at("-1e-12"), ""); // round-off
}

TEST(ExpressionScope, APinPushesNoRing) {
  const Folder folder;
  const std::string push = "$LOAD CASE=P TYPE=BEARING\n A.XMIN 1 0\n$END\n";
  const auto codes = [&](const std::string& state) {
    return Reading(folder,
                   head + block("A", plane + " X0=1") + material() + property("A", state) + push)
        .codes();
  };
  EXPECT_EQ(codes("AXI"), "E313");
  EXPECT_EQ(codes("STRESS"), "");
}

TEST(ExpressionScope, ContactIsThereInEachDimension) {
  const Folder folder;
  const auto pair = [&](const std::string& mesh, const std::string& shift, const std::string& state,
                        const std::string& low, const std::string& high,
                        const std::string& more = "") {
    return notes(Reading(folder, head + block("A", mesh) + block("B", mesh + shift) + material() +
                                     property("A", state) + property("B", state) +
                                     "$CONTACT NAME=C SLAVE=B." + low + " MASTER=A." + high + more +
                                     "\n$END\n"));
  };
  using Notes = std::vector<std::string>;
  EXPECT_EQ(pair(solid, " Z0=1", "SOLID", "ZMIN", "ZMAX"), Notes{});
  EXPECT_EQ(pair(solid, " Z0=1", "SOLID", "ZMIN", "ZMAX", " TYPE=BONDED"), Notes{});
  EXPECT_EQ(pair(solid, " Z0=1", "SOLID", "ZMIN", "ZMAX", " MU=0.1"), Notes{});
  EXPECT_EQ(pair(solid, " Z0=1", "SOLID", "ZMIN", "ZMAX", " PAIRING=NODE"), Notes{});
  EXPECT_EQ(pair(plane, " Y0=2", "STRESS", "YMIN", "YMAX"), Notes{});
  EXPECT_EQ(pair(plane, " Y0=2", "AXI", "YMIN", "YMAX"), Notes{});
}

TEST(ExpressionScope, CracksAreOfThePlane) {
  const Folder folder;
  const auto cracked = [&](const std::string& state, const std::string& mat,
                           const std::string& more = "") {
    return notes(Reading(folder, head + block("A", plane) + material(mat) + property("A", state) +
                                     crack + more + "$END\n"));
  };
  using Notes = std::vector<std::string>;
  EXPECT_EQ(cracked("STRESS", "NU=0.3"), Notes{});
  EXPECT_EQ(cracked("AXI", "NU=0.3"), Notes{});
  EXPECT_EQ(
      notes(Reading(folder, head + block("A", plane) + material("NU=0.3") + property("A", "AXI") +
                                "$CRACK NAME=C NET=A A0=0.5 ANGLE=90[deg] STATE=STRESS\n 2 "
                                "0\n$END\n")),
      Notes{"$CRACK STATE=STRESS about an axis, where a front is in plane strain,"});
  EXPECT_EQ(cracked("STRAIN", "NU=0.495"),
            Notes{"$CRACK with QUAMC8 elements and nu = 0.495, nearly incompressible,"});
  EXPECT_EQ(cracked("STRAIN", "NU=0.48"), Notes{});
  EXPECT_EQ(cracked("STRESS", "NU=0.495"), Notes{}); // free to change its thickness
  EXPECT_EQ(cracked("STRESS", "NU=0.3 ALPHA=1e-5", "$LOAD CASE=H TYPE=TEMPERATURE\n A.BODY 1\n"),
            Notes{});
}

TEST(ExpressionScope, CracksInSpace) {
  const Folder folder;
  const auto cracked = [&](const std::string& card, const std::string& more = "") {
    return notes(Reading(folder, head + block("A", solid) + material() + property("A", "SOLID") +
                                     card + more + "$END\n"));
  };
  using Notes = std::vector<std::string>;
  const std::string penny = "$CRACK NAME=C NET=A A=0.1 X0=0.5 Y0=0.5 Z0=0.5 NORMAL=Z\n";
  EXPECT_EQ(cracked(penny), Notes{});
  EXPECT_EQ(cracked(penny, "$TIPNET CRACK=C RADIUS=0.02 RINGS=4\n$VCE CRACK=C DOMAINS=2,3\n"),
            Notes{});
  EXPECT_EQ(cracked(penny, "$TIPNET CRACK=C TOL=0.01\n"), Notes{});
  EXPECT_EQ(cracked(penny, "$TIPNET CRACK=C PATCH=NO\n"), Notes{"$TIPNET PATCH=NO in space"});
  EXPECT_EQ(cracked(penny, "$VCE CRACK=C SHIFT=1e-4\n"), Notes{"$VCE SHIFT in space"});
  EXPECT_EQ(cracked(penny, "$LOAD CASE=P TYPE=TRACTION\n A.ZMAX 0 0 1\n$STEP NAME=S\n LOAD P 1\n"
                           "$GROW LAW=INCREMENT KMAX=S\n  0.1 0.2\n"),
            Notes{});
}

} // namespace
} // namespace spricka::deck::test_scope
