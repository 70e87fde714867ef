// SPDX-License-Identifier: GPL-3.0-or-later
// Places along a straight contact belong to the deck's slave, whichever side carries the
// multipliers.
#include "tests/unit/support/run_text.hpp"

#include <array>
#include <fmt/format.h>

namespace spricka::test_slave_places {
namespace {

struct Side {
  int n = 8;
  double E = 1000.0;
};

// A punch, 1 to 3 on a bed 0 to 8, pressed down; two of them, 5 to 6 as well. The slave runs with
// its body on its left: the top of the bed from x = 8, the foot of the punch from x = 1.
std::string punch(const Side& bed, const Side& foot, bool bed_is_slave, const std::string& checks) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=BED
  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=8 LY=2 Y0=-2 NX={0} NY=4
$ENDNET
$NET NAME=P
  $MESH SHAPE=BLOCK TYPE=QUAMC8 X0=1 LX=2 LY=1 NX={1} NY=2
$ENDNET
$NET NAME=Q
  $MESH SHAPE=BLOCK TYPE=QUAMC8 X0=5 LX=1 LY=1 NX={1} NY=2
$ENDNET
$MATERIAL NAME=B E={2} NU=0.3
$MATERIAL NAME=F E={3} NU=0.3
$PROPERTY ESET=BED.BODY MATERIAL=B STATE=STRAIN
$PROPERTY ESET=P.BODY MATERIAL=F STATE=STRAIN
$PROPERTY ESET=Q.BODY MATERIAL=F STATE=STRAIN
$FREEDOM CLASS=SUPPRESSED DOF=XY
  BED.YMIN
$FREEDOM CLASS=SUPPRESSED DOF=X
  P.YMAX
  Q.YMAX
$FSET NAME=FEET
  P.YMIN
  Q.YMIN
$CONTACT NAME=C {4}
$LOAD CASE=T TYPE=PRESSURE
  P.YMAX 1
  Q.YMAX 1
$STEP NAME=S
  LOAD T 1
$CHECK
{5}$END
)",
                     bed.n, foot.n, bed.E, foot.E,
                     bed_is_slave ? "SLAVE=BED.YMAX MASTER=FEET" : "SLAVE=FEET MASTER=BED.YMAX",
                     checks);
}

constexpr std::array<std::array<Side, 2>, 4> choices{{{Side{64, 1000.0}, Side{4, 900.0}},
                                                      {Side{16, 1000.0}, Side{16, 900.0}},
                                                      {Side{16, 900.0}, Side{16, 1000.0}},
                                                      {Side{64, 1000.0}, Side{8, 2000.0}}}};

TEST(SlavePlaces, OfTheBedWhicheverSideIsSofterOrCoarser) {
  for (const auto& [bed, foot] : choices) {
    const test::Folder folder;
    const test::Outcome outcome =
        test::run_text(folder, punch(bed, foot, true,
                                     R"(  ARC.FROM(C,S) = 5 ABS 0.4 SOURCE 'the bed runs from x = 8'
  ARC.TO(C,S)   = 7 ABS 0.4 SOURCE 'the bed runs from x = 8'
  ARC.PARTS(C,S) = 2 ABS 1e-9 SOURCE 'two punches'
  ARC.PART.FROM(C,S,1) = 2 ABS 0.4 SOURCE 'second punch'
  ARC.PART.TO(C,S,1)   = 3 ABS 0.4 SOURCE 'second punch'
  ARC.PART.FROM(C,S,2) = 5 ABS 0.4 SOURCE 'first punch'
  CPRESS.AT(C,S,6)  = 1 ABS 0.35 SOURCE 'below the middle of the first punch'
  CPRESS.AT(C,S,4)  = 0 ABS 1e-9 SOURCE 'between the punches'
)"));
    EXPECT_EQ(outcome.exit_code, 0)
        << outcome.messages << test::slurp(folder.path() / "out" / "listing.txt");
  }
}

TEST(SlavePlaces, OfTheFeetOneBehindTheOther) {
  for (const auto& [bed, foot] : choices) {
    const test::Folder folder;
    const test::Outcome outcome = test::run_text(
        folder, punch(bed, foot, false, R"(  ARC.FROM(C,S) = 0 ABS 0.4 SOURCE 'whole foot'
  ARC.TO(C,S)   = 2 ABS 0.4 SOURCE 'whole foot'
  CPRESS.AT(C,S,1)  = 1 ABS 0.35 SOURCE 'middle of the first punch'
)"));
    EXPECT_EQ(outcome.exit_code, 0)
        << outcome.messages << test::slurp(folder.path() / "out" / "listing.txt");
  }
}

} // namespace
} // namespace spricka::test_slave_places
