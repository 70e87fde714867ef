// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/check_text.hpp"

#include <fmt/format.h>

namespace spricka::test_contact_sense {
namespace {

struct Joint {
  double pin = 10.0;    ///< radius of the pin; the bore has 10
  double at = 0.0;      ///< its centre along x
  std::string fit = ""; ///< keys of $CONTACT
  std::string slave = "PIN.OUTER";
  std::string master = "RING.INNER";
  std::string sets = ""; ///< further cards
  std::string type = "QUAMC8";
  int around = 48; ///< elements of the pin
};

std::string deck(const Joint& j) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=PIN
$MESH SHAPE=RING TYPE={6} RI=0 RO={0} X0={1} NR=4 NT={7}
$ENDNET
$NET NAME=RING
$MESH SHAPE=RING TYPE={6} RI=10 RO=20 NR=4 NT=40
$ENDNET
$MATERIAL NAME=M E=200000 NU=0.3
$PROPERTY ESET=PIN.BODY MATERIAL=M STATE=STRESS THICK=1
$PROPERTY ESET=RING.BODY MATERIAL=M STATE=STRESS THICK=1
{5}
$FREEDOM CLASS=SUPPRESSED DOF=XY
  RING.OUTER
$LOAD CASE=F TYPE=RESULTANT
  PIN.BODY 500 300
$CONTACT NAME=C SLAVE={3} MASTER={4} {2}
$STEP NAME=S
  LOAD F 1
$END
)",
                     j.pin, j.at, j.fit, j.slave, j.master, j.sets, j.type, j.around);
}

std::string messages(const std::string& text) {
  const test::Folder folder;
  return test::check_text(folder, text).outcome.messages;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(ContactSense, WhatPeopleMeanIsNotWarnedOf) {
  for (const Joint& j :
       {Joint{.fit = "GAP=0"}, Joint{.fit = "DIAMETRAL=0.05"}, Joint{.fit = "GAP=0.1"},
        Joint{.fit = "GAP=0", .type = "QUAM4"}, Joint{.fit = "INTERFERENCE=0.02", .type = "TRIM3"},
        Joint{.pin = 9.9}, Joint{.pin = 9.9, .fit = "GAP=0.1"}, Joint{.fit = "MU=1.2"},
        Joint{.pin = 10.02, .fit = "INTERFERENCE=0.02"}, Joint{},
        // Curved elements leave the circle between their nodes by 4e-4.
        Joint{.fit = "INTERFERENCE=0.02", .around = 12}}) {
    EXPECT_FALSE(has(messages(deck(j)), "W44")) << messages(deck(j)) << j.pin << j.fit;
  }
}

TEST(ContactSense, ADeclaredGapThatTheDrawingContradicts) {
  for (const Joint& j :
       {Joint{.pin = 9.5, .fit = "GAP=0"}, Joint{.pin = 9.9, .fit = "INTERFERENCE=0.01"},
        Joint{.pin = 9.8, .at = 0.15, .fit = "GAP=0.2"}, Joint{.pin = 9.95, .fit = "GAP=0.5"}}) {
    EXPECT_TRUE(has(messages(deck(j)), "warning W442")) << messages(deck(j)) << j.pin << j.fit;
  }
}

// The bore's set without a quarter: there nothing stands opposite the pin, though the body does.
TEST(ContactSense, FacesThatAreMissingInASet) {
  const std::string part = "$FSET NAME=PART FROM=RING.INNER WHERE=(x > -1)\n";
  const std::string found = messages(deck({.fit = "GAP=0", .master = "PART", .sets = part}));
  EXPECT_TRUE(has(found, "warning W443")) << found;
}

TEST(ContactSense, FitsThatAreNotSmall) {
  EXPECT_TRUE(has(messages(deck({.fit = "INTERFERENCE=2"})), "warning W444"));
  EXPECT_TRUE(has(messages(deck({.fit = "DIAMETRAL=0.5"})), "warning W444"));
  EXPECT_TRUE(has(messages(deck({.pin = 10.3})), "warning W444"));
  EXPECT_FALSE(has(messages(deck({.fit = "INTERFERENCE=0.09"})), "warning W444"));
}

TEST(ContactSense, GapsFarAboveTheDrawnOne) {
  EXPECT_TRUE(has(messages(deck({.fit = "GAP=0.2"})), "warning W444"));
  EXPECT_TRUE(has(messages(deck({.fit = "DIAMETRAL=-0.8"})), "warning W444"));
  EXPECT_TRUE(has(messages(deck({.fit = "GAP=0.05 TYPE=BONDED"})), "warning W444"));
  EXPECT_FALSE(has(messages(deck({.fit = "GAP=0 TYPE=BONDED"})), "warning W444"));
  EXPECT_FALSE(has(messages(deck({.pin = 9.5, .fit = "GAP=0.5"})), "warning W444"));
}

TEST(ContactSense, FrictionInPerCent) {
  const std::string found = messages(deck({.fit = "GAP=0 MU=15"}));
  EXPECT_TRUE(has(found, "warning W445")) << found;
  EXPECT_TRUE(has(found, "MU=0.15")) << found;
  EXPECT_TRUE(has(messages(deck({.fit = "GAP=0 MU=-0.1"})), "error E109"));
}

std::string without_contact(const Joint& j, const std::string& support) {
  std::string text = deck(j);
  const std::size_t at = text.find("$CONTACT");
  text.erase(at, text.find('\n', at) - at);
  text.insert(text.find("$LOAD CASE"), support);
  return text;
}

TEST(ContactSense, ABodyWithoutItsContactIsNamedWithItsNeighbour) {
  const std::string found = messages(without_contact({}, ""));
  EXPECT_TRUE(has(found, "no $CONTACT and no common node joins it with RING")) << found;
  EXPECT_TRUE(has(found, "PIN.OUTER and RING.INNER")) << found;
}

TEST(ContactSense, BodiesThatOverlapAsDrawn) {
  const std::string held = "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  PIN.OUTER\n";
  EXPECT_TRUE(has(messages(without_contact({.pin = 10.1}, held)), "warning W446"));
  EXPECT_FALSE(has(messages(without_contact({}, held)), "W446"));
  EXPECT_FALSE(has(messages(without_contact({.pin = 15.0}, held)), "W446")); // upon each other
  EXPECT_FALSE(has(messages(without_contact({.pin = 9.0}, held)), "W446"));
}

} // namespace
} // namespace spricka::test_contact_sense
