// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/rigid_motion.hpp"
#include "tests/unit/support/run_text.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

namespace spricka::test_quantities {
namespace {

// A bar under tension: every quantity of $CHECK that has a closed form here.
TEST(Quantities, BarUnderTension) {
  const test::Folder folder;
  const test::Outcome outcome = test::run_text(folder, R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=2 NX=5 NY=2
$MATERIAL NAME=M E=1000 NU=0.25
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS THICK=3
$FREEDOM CLASS=SUPPRESSED DOF=X
  XMIN
$NSET NAME=CORNER WHERE=(abs(x) < 1e-9 and abs(y) < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=Y
  CORNER
$LOAD CASE=PULL TYPE=TRACTION
  XMAX 4 0
$STEP NAME=HALF
  LOAD PULL 0.5
$STEP NAME=FULL
  LOAD PULL 1
$CHECK
  S.XX.MIN(BODY,FULL)     = 4      REL 1e-10 SOURCE 'bar'
  S.XX.MAX(XMAX,HALF)     = 2      REL 1e-10 SOURCE 'bar'
  S.YY.MAX(BODY,FULL)     = 0      ABS 1e-10 SOURCE 'bar'
  S.MISES.MAX(BODY,FULL)  = 4      REL 1e-10 SOURCE 'bar'
  S.XX.AT(3.3,1.1,FULL)   = 4      REL 1e-10 SOURCE 'bar'
  U.X.MAX(BODY,FULL)      = 0.04   REL 1e-10 SOURCE 'bar'
  U.X.AT(10,2,FULL)       = 0.04   REL 1e-10 SOURCE 'bar'
  U.Y.MIN(BODY,FULL)      = -0.002 REL 1e-10 SOURCE 'bar'
  REACTION(XMIN,FULL,X)   = -24    REL 1e-10 SOURCE 'bar'
$END
)");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
}

TEST(Quantities, PointOutsideTheBodyFailsWithItsReason) {
  const test::Folder folder;
  const test::Outcome outcome = test::run_text(folder, R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=2 NX=5 NY=2
$MATERIAL NAME=M E=1000 NU=0.25
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  XMIN
$LOAD CASE=PULL TYPE=TRACTION
  XMAX 4 0
$STEP NAME=FULL
  LOAD PULL 1
$CHECK
  S.XX.AT(33,1,FULL) = 4 REL 1e-10 SOURCE 'bar'
$END
)");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.messages.find("outside the body"), std::string::npos) << outcome.messages;
}

// Two layers that are stretched together, NU = 0: each has its own stress, up to the border. Energy
// is half the work, by the layers' nets nothing is lost.
TEST(Quantities, NothingIsAveragedAcrossTheBorderOfAMaterial) {
  const test::Folder folder;
  const test::Outcome outcome = test::run_text(folder, R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=2 NX=5 NY=2
$ESET NAME=SOFT WHERE=(y < 1)
$ESET NAME=STIFF WHERE=(y > 1)
$NSET NAME=BORDER WHERE=(abs(y - 1) < 1e-9)
$MATERIAL NAME=S E=1000 NU=0
$MATERIAL NAME=H E=5000 NU=0
$PROPERTY ESET=SOFT MATERIAL=S STATE=STRESS THICK=3
$PROPERTY ESET=STIFF MATERIAL=H STATE=STRESS THICK=3
$FREEDOM CLASS=SUPPRESSED DOF=X
  XMIN
$FREEDOM CLASS=SUPPRESSED DOF=Y
  YMIN
$FREEDOM CLASS=PRESCRIBED DOF=X
  XMAX
$LOAD CASE=PULL TYPE=DISP
  XMAX 0.1 0
$STEP NAME=PUSH
  LOAD PULL -1
$STEP NAME=FULL
  LOAD PULL 1
$CHECK
  S.XX.MAX(SOFT,FULL)     = 10   REL 1e-10 SOURCE 'bar'
  S.XX.MIN(STIFF,FULL)    = 50   REL 1e-10 SOURCE 'bar'
  S.XX.MIN(BORDER,FULL)   = 10   REL 1e-10 SOURCE 'bar'
  S.XX.MAX(BORDER,FULL)   = 50   REL 1e-10 SOURCE 'bar'
  S.P1.MAX(STIFF,FULL)    = 50   REL 1e-10 SOURCE 'bar'
  S.P2.MAX(BODY,FULL)     = 0    ABS 1e-10 SOURCE 'bar'
  S.P3.MIN(BODY,FULL)     = 0    ABS 1e-10 SOURCE 'bar'
  S.P1.MAX(BODY,PUSH)     = 0    ABS 1e-10 SOURCE 'bar'
  S.P3.MIN(STIFF,PUSH)    = -50  REL 1e-10 SOURCE 'bar'
  S.P3.AT(5.5,0.5,PUSH)   = -10  REL 1e-10 SOURCE 'bar'
  ENERGY(*,FULL)          = 9    REL 1e-10 SOURCE 'half of 180 N times 0.1 mm'
$OUTPUT FILE='soft.csv' FORMAT=CSV EVERY=END
  S SOFT
$OUTPUT FILE='border.csv' FORMAT=CSV EVERY=END
  S BORDER
$END
)");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
  double low = 1e9;
  double high = -1e9;
  int borders = 0;
  for (const char* const file : {"soft.csv", "border.csv"}) {
    std::ifstream in(folder.path() / "out" / file);
    for (std::string line; std::getline(in, line);) {
      const std::size_t at = line.find(",XX,");
      if (at != std::string::npos) {
        const double value = std::stod(line.substr(at + 4));
        if (std::string(file) == "soft.csv") {
          EXPECT_NEAR(value, 10.0, 1e-9) << line;
        } else {
          low = std::min(low, value);
          high = std::max(high, value);
          ++borders;
        }
      }
    }
  }
  EXPECT_NEAR(low, 10.0, 1e-9);
  EXPECT_NEAR(high, 50.0, 1e-9);
  EXPECT_EQ(borders, 2 * 11) << "each node of the border with both of its stresses";
}

// Two nets tied end to end, NU = 0: 4 MPa in both, each with its own share of the energy; the tie
// hands 24 N over, and none is created.
TEST(Quantities, EnergyAndResultantsOfTiedNets) {
  const test::Folder folder;
  const test::Outcome outcome = test::run_text(folder, R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=A
  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=2 NX=5 NY=2
$ENDNET
$NET NAME=B
  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=2 NX=4 NY=4 X0=10
$ENDNET
$MATERIAL NAME=S E=1000 NU=0
$MATERIAL NAME=H E=4000 NU=0
$PROPERTY ESET=A.BODY MATERIAL=S STATE=STRESS THICK=3
$PROPERTY ESET=B.BODY MATERIAL=H STATE=STRESS THICK=3
$FREEDOM CLASS=SUPPRESSED DOF=X
  A.XMIN
$FREEDOM CLASS=SUPPRESSED DOF=Y
  A.YMIN
$MPC TYPE=TRANSITION SLAVE=B.XMIN MASTER=A.XMAX
$LOAD CASE=PULL TYPE=TRACTION
  B.XMAX 4 0
$STEP NAME=FULL
  LOAD PULL 1
$CHECK
  S.XX.MAX(A.BODY,FULL) = 4    REL 1e-9 SOURCE 'bar'
  S.XX.MIN(B.BODY,FULL) = 4    REL 1e-9 SOURCE 'bar'
  ENERGY(A,FULL)        = 0.48 REL 1e-9 SOURCE 'stress^2 / (2 E) over 60 mm^3'
  ENERGY(B,FULL)        = 0.12 REL 1e-9 SOURCE 'stress^2 / (2 E) over 60 mm^3'
  ENERGY(*,FULL)        = 0.6  REL 1e-9 SOURCE 'half of 24 N times 0.05 mm'
$END
)");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
  std::istringstream listing(test::slurp(folder.path() / "out/listing.txt"));
  std::map<std::string, std::vector<double>> rows;
  bool inside = false;
  for (std::string line; std::getline(listing, line);) {
    inside = (inside || line.find("Force balance by net") != std::string::npos) &&
             line.find("Estimated") == std::string::npos;
    std::istringstream words(line);
    std::string step;
    std::string net;
    if (inside && words >> step >> net && step == "FULL") {
      for (double value = 0.0; words >> value;) {
        rows[net].push_back(value);
      }
    }
  }
  // applied x y, reaction x y, contact x y, tie x y, left over, energy
  ASSERT_EQ(rows["A"].size(), 10U) << test::slurp(folder.path() / "out/listing.txt");
  ASSERT_EQ(rows["B"].size(), 10U);
  EXPECT_EQ(rows["A"][2], -24.0);
  EXPECT_EQ(rows["A"][6], 24.0);
  EXPECT_EQ(rows["B"][0], 24.0);
  EXPECT_EQ(rows["B"][6], -24.0);
  for (const auto& [net, row] : rows) {
    EXPECT_LT(row[8], 1e-9) << net;
  }
}

// A heated block: free, it has no elastic energy; held along x, E (alpha T)^2 / 2 for each volume.
TEST(Quantities, EnergyOfTemperaturesIsTheElasticOne) {
  for (const bool held : {false, true}) {
    const test::Folder folder;
    const test::Outcome outcome = test::run_text(
        folder, std::string(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=2 NX=5 NY=2
$MATERIAL NAME=M E=1000 NU=0.25 ALPHA=1e-5
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS THICK=3
$FREEDOM CLASS=SUPPRESSED DOF=X
  XMIN
$FREEDOM CLASS=SUPPRESSED DOF=Y
  YMIN
)") + (held ? "$FREEDOM CLASS=SUPPRESSED DOF=X\n  XMAX\n" : "") +
                    R"($LOAD CASE=HEAT TYPE=TEMPERATURE
  BODY 100
$STEP NAME=HOT
  LOAD HEAT 1
$CHECK
)" +
                    (held ? "  ENERGY(*,HOT) = (1000*(1e-3)^2/2*60) REL 1e-10 SOURCE 'bar'\n"
                          : "  ENERGY(*,HOT) = 0 ABS 1e-14 SOURCE 'free'\n") +
                    "$END\n");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
  }
}

TEST(Quantities, AxisymmetricListingShowsWhatAResultantHas) {
  const test::Folder folder;
  const test::Outcome outcome = test::run_text(folder, R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 X0=10 LX=10 LY=2 NX=5 NY=2
$MATERIAL NAME=M E=1000 NU=0.25
$PROPERTY ESET=BODY MATERIAL=M STATE=AXI
$FREEDOM CLASS=SUPPRESSED DOF=Y
  YMIN
$LOAD CASE=PULL TYPE=TRACTION
  YMAX 0 4
$STEP NAME=FULL
  LOAD PULL 1
$CHECK
  REACTION(YMIN,FULL,Y) = (-4*pi*(400-100)) REL 1e-10 SOURCE 'ring'
  ENERGY(*,FULL)        = (4^2/2/1000*pi*(400-100)*2) REL 1e-10 SOURCE 'ring'
$END
)");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
  const std::string listing = test::slurp(folder.path() / "out/listing.txt");
  EXPECT_EQ(listing.find("applied x"), std::string::npos);
  EXPECT_NE(listing.find("applied y"), std::string::npos);
  EXPECT_NE(listing.find("full circumference"), std::string::npos);
}

// K1.AT reads where the front is nearest: K is that of another place when the front is elsewhere,
// which passes for right where K changes slowly. The run says so.
TEST(Quantities, PlacesThatAFrontDoesNotPassAreNamed) {
  const auto warnings = [](const std::string& x) {
    const test::Folder folder;
    const test::Outcome outcome = test::run_text(folder, R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=BODY
  $MESH SHAPE=BLOCK TYPE=HEXEC20 X0=0 Y0=0 Z0=-2 LX=1 LY=0.25 LZ=4 NX=4 NY=1 NZ=12
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY.BODY MATERIAL=M STATE=SOLID
$NSET NAME=P1 WHERE=(x > 1 - 1e-6 and z < -2 + 1e-6)
$NSET NAME=P2 WHERE=(x < 1e-6 and z < -2 + 1e-6)
$FREEDOM CLASS=SUPPRESSED DOF=XZ
  P1
$FREEDOM CLASS=SUPPRESSED DOF=Z
  P2
$FREEDOM CLASS=SUPPRESSED DOF=Y
  BODY.YMIN BODY.YMAX
$CRACK NAME=C1 NET=BODY X0=0.2 Y0=0.1 Z0=0
  0.5 -0.05 0
  0.5  0.3  0
$LOAD CASE=PULL TYPE=TRACTION
  BODY.ZMAX  0 0 1
  BODY.ZMIN  0 0 -1
$STEP NAME=PULL
  LOAD PULL 1
$CHECK
  K1.AT(C1,)" + x + R"(,0.1,0,PULL) = (2.824579*sqrt(pi/2)) REL 0.02 SOURCE 'Kaya and Erdogan 1987'
$END
)");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
    return outcome.messages;
  };
  EXPECT_EQ(warnings("0.505").find("nearest place"), std::string::npos);
  const std::string aside = warnings("0.52");
  EXPECT_NE(aside.find("front C1 is 0.02 mm from there, at 0.5 0.1 0"), std::string::npos) << aside;
}

// A motion of a solid body is told with all three components.
TEST(Quantities, RigidMotionInSpaceHasThreeComponents) {
  model::Mesh mesh;
  mesh.dim = 3;
  fe::Body body;
  for (const base::Vec3& x : {base::Vec3(0, 0, 0), base::Vec3(1, 0, 0), base::Vec3(0, 0, 1)}) {
    body.nodes.push_back(model::add_node(mesh, x, 1, base::NetId(0)));
  }
  const base::Vec3 way(3.0, 0.0, 4.0);
  const base::Vector motion = way.replicate(3, 1);
  EXPECT_EQ(analysis::describe_rigid_motion(mesh, body, motion), "direction (0.600, 0.000, 0.800)");
  base::Vector turned = motion;
  turned.head<3>() *= -1.0;
  EXPECT_EQ(analysis::describe_rigid_motion(mesh, body, turned),
            "translation (0.20, 0.00, 0.27) with rotation");
}

} // namespace
} // namespace spricka::test_quantities
