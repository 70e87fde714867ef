// SPDX-License-Identifier: GPL-3.0-or-later
#include "solved_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ranges>

#include <fmt/format.h>

namespace spricka {
namespace {

using test::solve_text;
using test::Solved;

const double root_pi = std::sqrt(std::numbers::pi);

// A plate |x|, |y| < 20 with loads on its rim and cracks in it; supports only keep it in place.
std::string plate(const std::string& cracks, const std::string& loads, int n = 16) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 X0=-20 Y0=-20 LX=40 LY=40 NX={0} NY={0}
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS THICK=3
$NSET NAME=LEFT  WHERE=(abs(x+20) < 1e-9 and abs(y+20) < 1e-9)
$NSET NAME=RIGHT WHERE=(abs(x-20) < 1e-9 and abs(y+20) < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  LEFT
$FREEDOM CLASS=SUPPRESSED DOF=Y
  RIGHT
{1}{2}$END
)",
                     n, cracks, loads);
}

// Stresses (sx, sy, txy) on the rim, and one step.
std::string stressed(double sx, double sy, double txy) {
  return fmt::format(R"($LOAD CASE=F TYPE=TRACTION
  XMAX {0} {2}
  XMIN {3} {5}
  YMAX {2} {1}
  YMIN {5} {4}
$STEP NAME=S
  LOAD F 1
)",
                     sx, sy, txy, -sx, -sy, -txy);
}

std::string slant(double angle, const std::string& keys) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return fmt::format("$CRACK NAME=C {}\n  {} {}\n  {} {}\n", keys, -c, -s, c, s);
}

// Bending x + r, as in benchmark F11.
std::string bent(double r, const std::string& keys = "") {
  return plate("$CRACK NAME=C " + keys + "\n  -1 0\n  1 0\n",
               fmt::format(R"($LOAD CASE=BEND TYPE=TRACTION
  YMAX 0 (x+{0})
  YMIN 0 (-x-{0})
$STEP NAME=S
  LOAD BEND 1
)",
                           r));
}

const results::ContactResult& faces(const Solved& solved, const std::string& name = "C.FACES") {
  const results::ContactResult* found = results::find_contact(solved.step(), name);
  EXPECT_NE(found, nullptr);
  return *found;
}

bool was_closed(const Solved& solved) {
  return std::ranges::any_of(solved.run.log, [](const results::LogLine& line) {
    return line.text.find("meet") != std::string::npos;
  });
}

// Hydrostatic pressure closes a crack of any shape, and nothing of it is left: uniform stress, the
// displacement that of the plate without a crack, pressure p at every node of the faces.
TEST(LipContact, PressureAllRoundLeavesNothingOfACrack) {
  for (const std::string crack :
       {"$CRACK NAME=C\n  -1 0.2\n  1 -0.1\n", "$CRACK NAME=C\n  -2 0\n  0 1\n  2 0.5\n",
        "$CRACK NAME=C LINE=SMOOTH\n  -2 0\n  0 1\n  2 0\n",
        "$CRACK NAME=C\n  -20 1\n  -15 1.5\n"}) {
    const std::optional<Solved> solved = solve_text(plate(crack, stressed(-2.0, -2.0, 0.0)));
    ASSERT_TRUE(solved);
    const double strain = -2.0 * 0.7 / 1000.0;
    for (std::size_t n = 0; n < solved->mesh().node_count(); ++n) {
      if (!model::nodes_in_use(solved->mesh())[n]) {
        continue;
      }
      const base::Vec3& x = solved->mesh().x[n];
      const base::Vec3 u = solved->u(base::NodeId(n));
      EXPECT_NEAR(u.x(), strain * (x.x() + 20.0), 1e-9 * std::abs(strain) * 40.0) << crack;
      EXPECT_NEAR(u.y(), strain * (x.y() + 20.0), 1e-9 * std::abs(strain) * 40.0) << crack;
    }
    EXPECT_NEAR(solved->step().energy, 0.5 * 2.0 * 2.0 * 2.0 * 0.7 / 1000.0 * 1600.0 * 3.0,
                1e-9 * 13.44);
    for (const results::ContactPoint& p : faces(*solved).points) {
      EXPECT_NEAR(p.p_lumped, 2.0, 1e-7) << crack;
      EXPECT_TRUE(p.closed);
    }
    for (const results::TipResult& tip : solved->step().tips) {
      EXPECT_EQ(tip.K1, 0.0);
      EXPECT_NEAR(tip.K2, 0.0, 1e-6);
      EXPECT_NEAR(tip.T, -2.0, 0.02) << crack;
      EXPECT_TRUE(tip.closed);
      EXPECT_TRUE(tip.doubt.empty());
      for (const double K1 : tip.K1_domain) { // the rings find it too
        EXPECT_NEAR(K1, 0.0, 2e-3 * 2.0 * root_pi) << crack;
      }
    }
  }
}

// A path along the deck's own elements, so that the body without a crack has the same mesh.
std::string split_block(const std::string& crack, const std::string& load) {
  return R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 X0=0 Y0=-3 LX=8 LY=6 NX=8 NY=6
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN
$NSET NAME=LINE WHERE=(abs(y) < 1e-9) ORDER=(x)
$NSET NAME=FOOT WHERE=(abs(y+3) < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  FOOT
)" + crack +
         "$LOAD CASE=F TYPE=TRACTION\n  " + load + "\n$STEP NAME=S\n  LOAD F 1\n$END\n";
}

void expect_same_bodies(const std::string& crack, const std::string& load) {
  const std::optional<Solved> whole = solve_text(split_block("", load));
  const std::optional<Solved> cracked = solve_text(split_block(crack, load));
  ASSERT_TRUE(whole && cracked);
  EXPECT_TRUE(was_closed(*cracked));
  const double size = whole->step().u.cwiseAbs().maxCoeff();
  const Eigen::Index n = whole->step().u.size();
  EXPECT_LT((whole->step().u - cracked->step().u.head(n)).cwiseAbs().maxCoeff(), 1e-9 * size);
  EXPECT_NEAR(cracked->step().energy, whole->step().energy, 1e-9 * whole->step().energy);
  EXPECT_EQ(cracked->step().tips.front().K1, 0.0);
  EXPECT_EQ(cracked->step().tips.front().K2, 0.0);
}

// Faces that friction holds everywhere are no crack.
TEST(LipContact, FacesThatStickAreNoCrack) {
  const std::string crack =
      "$CRACK NAME=C PATH=LINE A0=4 MU=5\n$TIPNET CRACK=C PATCH=NO QUARTER=NO\n";
  expect_same_bodies(crack, "YMAX (0.2+0.1*x) (-2-x)");
  expect_same_bodies(crack, "YMAX 0 (-9-0.1*x*x)");
}

// A crack on the line of symmetry, as a whole body and as either half of it, opening at its tip
// and closed at its mouth.
TEST(LipContact, HalvesAreTheWhole) {
  const auto deck = [](double y0, double ly, int ny, const std::string& held,
                       const std::string& load) {
    return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 X0=0 Y0={} LX=8 LY={} NX=16 NY={}
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN THICK=2
$NSET NAME=LINE WHERE=(abs(y) < 1e-9) ORDER=(x)
$NSET NAME=END WHERE=(abs(y) < 1e-9 and abs(x-8) < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=X
  END
$FREEDOM CLASS=SUPPRESSED DOF=Y
  {}
$CRACK NAME=C PATH=LINE A0=5
$TIPNET CRACK=C PATCH=NO RINGS=2
$LOAD CASE=F TYPE=TRACTION
{}$STEP NAME=S
  LOAD F 1
$CHECK
  ARC.FROM(C.FACES,S) = 0 ABS 1e-9
$END
)",
                       y0, ly, ny, held, load);
  };
  const std::string up = "  YMAX 0 (x-3)\n";
  const std::string down = "  YMIN 0 (3-x)\n";
  const std::optional<Solved> whole = solve_text(deck(-6.0, 12.0, 24, "END", up + down));
  const std::optional<Solved> upper = solve_text(deck(0.0, 6.0, 12, "LINE", up));
  const std::optional<Solved> lower = solve_text(deck(-6.0, 6.0, 12, "LINE", down));
  ASSERT_TRUE(whole && upper && lower);
  const results::ContactResult& all = faces(*whole);
  EXPECT_GT(all.closed, 4);
  EXPECT_LT(all.closed, all.rows);
  EXPECT_NEAR(all.arc_from, 0.0, 1e-9);
  for (const Solved* half : {&*upper, &*lower}) {
    const results::ContactResult& own = faces(*half);
    EXPECT_EQ(own.closed, all.closed);
    EXPECT_EQ(own.rows, all.rows);
    EXPECT_NEAR(own.arc_from, all.arc_from, 1e-9);
    EXPECT_NEAR(own.arc_to, all.arc_to, 1e-8);
    ASSERT_EQ(own.points.size(), all.points.size());
    for (std::size_t i = 0; i < all.points.size(); ++i) {
      EXPECT_NEAR(own.points[i].p_lumped, all.points[i].p_lumped, 1e-8);
      EXPECT_NEAR(2.0 * own.points[i].gap, all.points[i].gap, 1e-9);
    }
    EXPECT_NEAR(half->step().tips[0].K1, whole->step().tips[0].K1, 1e-8);
    EXPECT_GT(half->step().tips[0].K1, 1.0);
    EXPECT_TRUE(half->step().tips[0].doubt.empty());
  }
}

// F11: closed from -a to c = -a/3 - 4 r a/3, K of the open part of half length b = 2 (1 + r) a/3.
TEST(LipContact, ClosesInPartUnderBending) {
  for (const double r : {-0.9, -0.5, 0.0, 0.1, 0.4}) {
    const std::optional<Solved> solved = solve_text(bent(r));
    ASSERT_TRUE(solved);
    const double b = 2.0 * (1.0 + r) / 3.0;
    const double K = b * std::sqrt(std::numbers::pi * b);
    EXPECT_EQ(solved->step().tips[0].K1, 0.0);
    EXPECT_TRUE(solved->step().tips[0].closed);
    EXPECT_FALSE(solved->step().tips[1].closed);
    EXPECT_NEAR(solved->step().tips[1].K1, K, 0.005 * K) << r;
    EXPECT_NEAR(faces(*solved).arc_to, 2.0 - 2.0 * b, 0.02) << r;
    EXPECT_TRUE(solved->step().tips[1].doubt.empty());
  }
}

TEST(LipContact, OpenFacesCostNothing) {
  const std::optional<Solved> contact = solve_text(bent(0.6, "FACES=CONTACT MU=0.3"));
  const std::optional<Solved> free = solve_text(bent(0.6, "FACES=FREE"));
  ASSERT_TRUE(contact && free);
  EXPECT_TRUE(contact->step().u == free->step().u);
  EXPECT_EQ(contact->step().tips[1].K1, free->step().tips[1].K1);
  EXPECT_EQ(contact->run.log.size(), free->run.log.size());
  EXPECT_TRUE(contact->step().contacts.empty());
  EXPECT_TRUE(contact->step().notes.empty());
  EXPECT_NEAR(contact->step().tips[0].K1, 0.1 * root_pi, 0.01);
}

TEST(LipContact, OpensEverywhereOrNowhere) {
  const std::optional<Solved> shut = solve_text(bent(-1.2));
  ASSERT_TRUE(shut);
  for (const results::TipResult& tip : shut->step().tips) {
    EXPECT_EQ(tip.K1, 0.0);
    EXPECT_TRUE(tip.closed);
    EXPECT_NEAR(tip.K2, 0.0, 1e-6);
  }
  EXPECT_EQ(faces(*shut).closed, faces(*shut).rows);
}

// K2 = -(tau - mu sigma_n) sqrt(pi a) by slip, at any angle of the crack; the same on all rings,
// though the shear of the faces is not the same on all of them.
TEST(LipContact, SlipsAgainstFriction) {
  for (const double angle : {0.3, 0.8}) {
    for (const double mu : {0.0, 0.25}) {
      const double sn = std::cos(angle) * std::cos(angle);
      const double tau = std::cos(angle) * std::sin(angle);
      std::vector<double> K2;
      for (const int ring : {2, 3, 5}) {
        const std::optional<Solved> solved = solve_text(plate(
            slant(angle, fmt::format("MU={}", mu)) + fmt::format("$VCE CRACK=C DOMAINS={}\n", ring),
            stressed(0.0, -1.0, 0.0)));
        ASSERT_TRUE(solved);
        const results::StepResult& step = solved->step();
        K2.push_back(step.tips[1].K2);
        EXPECT_NEAR(step.tips[0].K2, step.tips[1].K2, 1e-4);
        EXPECT_EQ(step.tips[1].K1, 0.0);
        ASSERT_EQ(step.tips[1].K1_domain.size(), 1U);
        EXPECT_NEAR(step.tips[1].K1_domain[0], 0.0, 1e-3);
        EXPECT_NEAR(step.tips[1].G, step.tips[1].G_from_K, 1e-3 * step.tips[1].G);
        const results::ContactResult& lip = faces(*solved);
        EXPECT_LE(lip.shear_ratio, 1.0 + 1e-9);
        EXPECT_NEAR(lip.min_pressure, sn, 0.005);
        EXPECT_GE(lip.friction_work, 0.0);
        for (const results::Balance& body : step.balance) { // equal and opposite
          EXPECT_LT(body.contact.norm(), 1e-9);
        }
      }
      const double exact = -std::max(0.0, tau - mu * sn) * root_pi;
      EXPECT_NEAR(K2[0], exact, 0.005 * root_pi);
      EXPECT_NEAR(K2[1], K2[0], 1e-3 * root_pi);
      EXPECT_NEAR(K2[2], K2[0], 1e-3 * root_pi);
    }
  }
}

// A crack, its mirror image, and it turned by a right angle together with its loads.
TEST(LipContact, MirroredAndTurnedCracksAgree) {
  const auto solve = [](double angle, double sx, double sy) {
    return solve_text(plate(slant(angle, "MU=0.2"), stressed(sx, sy, 0.0)));
  };
  const double angle = 0.7;
  const std::optional<Solved> plain = solve(angle, 0.0, -1.0);
  const std::optional<Solved> mirrored = solve(-angle, 0.0, -1.0);
  const std::optional<Solved> turned = solve(angle + 0.5 * std::numbers::pi, -1.0, 0.0);
  ASSERT_TRUE(plain && mirrored && turned);
  const double K2 = plain->step().tips[1].K2;
  EXPECT_NEAR(mirrored->step().tips[1].K2, -K2, 1e-4 * std::abs(K2));
  EXPECT_NEAR(turned->step().tips[1].K2, K2, 1e-4 * std::abs(K2));
}

// Energy of two lengths: G = dU/da for dead loads, per tip, with the faces partly or wholly closed
// and free to slip. The patch follows the length, so that its mesh does not change.
TEST(LipContact, EnergyReleaseIsThatOfTheEnergy) {
  const auto solve = [](double a, const std::string& load) {
    return solve_text(plate(fmt::format("$CRACK NAME=C\n  {0} {0}\n  {1} {1}\n", -a, a), load, 8));
  };
  for (const std::string& load : {stressed(0.0, -1.0, 0.0), stressed(-1.0, -0.2, 0.4)}) {
    const double a = 4.0 / std::sqrt(2.0);
    const double da = 0.02 * a;
    const std::optional<Solved> at = solve(a, load);
    const std::optional<Solved> less = solve(a - da, load);
    const std::optional<Solved> more = solve(a + da, load);
    ASSERT_TRUE(at && less && more);
    EXPECT_TRUE(was_closed(*at));
    const double differenced =
        (more->step().energy - less->step().energy) / (2.0 * da * std::sqrt(2.0)) / 3.0;
    const double G = at->step().tips[0].G + at->step().tips[1].G;
    EXPECT_NEAR(G, differenced, 0.01 * G);
    EXPECT_NEAR(G, at->step().tips[0].G_from_K + at->step().tips[1].G_from_K, 2e-3 * G);
  }
}

// Loaded, relieved and loaded again: the closed form of decks/closed_crack_cycle.deck, in steps of
// any size.
TEST(LipContact, RemembersSlip) {
  for (const int parts : {1, 5}) {
    std::string steps = "$LOAD CASE=F TYPE=TRACTION\n  YMAX 0 -1\n  YMIN 0 1\n";
    const std::vector<double> loads{1.0, 0.6, 0.3, 0.5, 1.0};
    for (std::size_t s = 0; s < loads.size(); ++s) {
      steps += fmt::format("$STEP NAME=S{} SUBSTEPS={}\n  LOAD F {}\n", s, parts, loads[s]);
    }
    const std::optional<Solved> solved =
        solve_text(plate(slant(0.25 * std::numbers::pi, "MU=0.3"), steps));
    ASSERT_TRUE(solved);
    const std::vector<double> exact{0.35, 0.35, 0.195, 0.195, 0.35};
    for (std::size_t s = 0; s < exact.size(); ++s) {
      EXPECT_NEAR(solved->step(s).tips[0].K2, -exact[s] * root_pi, 0.005 * root_pi) << s;
      EXPECT_EQ(solved->step(s).tips[0].K1, 0.0);
    }
    EXPECT_NEAR(solved->step(1).tips[0].K2, solved->step(0).tips[0].K2, 1e-8);
  }
}

TEST(LipContact, ThreadsChangeNoBit) {
  const std::string deck = plate(slant(0.6, "MU=0.2"), stressed(0.3, -1.0, 0.1));
  const std::optional<Solved> one = solve_text(deck, 1);
  const std::optional<Solved> four = solve_text(deck, 4);
  ASSERT_TRUE(one && four);
  EXPECT_TRUE(was_closed(*one));
  EXPECT_TRUE(one->step().u == four->step().u);
  EXPECT_EQ(one->step().tips[0].K2, four->step().tips[0].K2);
}

// Two cracks of which one closes: the other is left as it is.
TEST(LipContact, OnlyFacesThatMeetAreAPair) {
  const std::string cracks = "$CRACK NAME=UP\n  -1 8\n  1 8\n$CRACK NAME=ACROSS\n  0 -9\n  0 -7\n";
  const std::optional<Solved> solved = solve_text(plate(cracks, stressed(-1.0, 1.0, 0.0)));
  ASSERT_TRUE(solved);
  ASSERT_EQ(solved->step().contacts.size(), 1U);
  EXPECT_EQ(solved->step().contacts[0].name, "ACROSS.FACES");
  EXPECT_GT(solved->step().tips[0].K1, 0.9 * root_pi);
  EXPECT_EQ(solved->step().tips[2].K1, 0.0);
}

// Linear elements and tips without quarter points have contact between their faces too.
TEST(LipContact, OnTheDecksOwnElements) {
  const auto solve = [](const std::string& type, const std::string& tip) {
    return solve_text(fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE={} X0=0 Y0=-6 LX=8 LY=12 NX=32 NY=48
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN
$NSET NAME=LINE WHERE=(abs(y) < 1e-9) ORDER=(x)
$NSET NAME=END WHERE=(abs(y) < 1e-9 and abs(x-8) < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  END
$NSET NAME=OTHER WHERE=(abs(y+6) < 1e-9 and abs(x-8) < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=X
  OTHER
$CRACK NAME=C PATH=LINE A0=5
{}$LOAD CASE=F TYPE=TRACTION
  YMAX 0 (x-3)
  YMIN 0 (3-x)
$STEP NAME=S
  LOAD F 1
$END
)",
                                  type, tip));
  };
  const std::optional<Solved> patch = solve("QUAMC8", "");
  ASSERT_TRUE(patch);
  const double K = patch->step().tips[0].K1;
  for (const std::string type : {"QUAM4", "QUAMC8", "QUAMC9"}) {
    const std::optional<Solved> solved = solve(type, "$TIPNET CRACK=C PATCH=NO QUARTER=NO\n");
    ASSERT_TRUE(solved);
    EXPECT_GT(faces(*solved).closed, 0) << type;
    EXPECT_GE(faces(*solved).min_pressure, 0.0);
    EXPECT_NEAR(faces(*solved).max_penetration, 0.0, 1e-12);
    EXPECT_NEAR(faces(*solved).arc_to, faces(*patch).arc_to, 0.15) << type;
    EXPECT_NEAR(solved->step().tips[0].K1, K, 0.01 * K) << type;
    EXPECT_FALSE(solved->step().tips[0].closed);
  }
}

// K on load paths on which the faces meet, between the steps or only beyond the last, is that of
// steps: bending x + r with r = 0.7 - t.
TEST(LipContact, LoadPathsCloseFaces) {
  const auto path = [](double beyond) {
    return plate("$CRACK NAME=C\n  -1 0\n  1 0\n", fmt::format(R"($LOAD CASE=BEND TYPE=TRACTION
  YMAX 0 (x)
  YMIN 0 (-x)
$LOAD CASE=PULL TYPE=TRACTION
  YMAX 0 1
  YMIN 0 -1
$STEP NAME=FIRST
  LOAD BEND 1
  LOAD PULL 0.7
$STEP NAME=LAST
  LOAD PULL {}
$LOADPATH NAME=P FROM=FIRST TO=LAST BEYOND={}
)",
                                                               0.7 - 2.0 / beyond, beyond));
  };
  for (const double beyond : {1.0, 16.0}) { // the ends of the second are both open
    const std::optional<Solved> solved = solve_text(path(beyond));
    ASSERT_TRUE(solved);
    const results::LoadPath& found = solved->run.increments[0].paths.at(0);
    EXPECT_LT(found.mismatch, 1e-6);
    EXPECT_TRUE(found.tips[1].doubt.empty());
    EXPECT_GT(found.t.size(), 10U);
    for (const double t : {0.05, 0.4, 0.7, 1.3, 1.95}) {
      const std::optional<Solved> step = solve_text(bent(0.7 - t));
      ASSERT_TRUE(step);
      for (const std::size_t tip : {std::size_t{0}, std::size_t{1}}) {
        EXPECT_NEAR(found.tips[tip].K1(0.5 * beyond * t), step->step().tips[tip].K1, 1e-6)
            << beyond << ' ' << t;
      }
    }
  }
}

// The mouth of a closed crack in the middle of a contact surface (S11): blocks under pressure from
// all sides do not feel the crack, whatever the pairing of their own contact.
TEST(LipContact, MouthInAnotherContact) {
  for (const std::string pairing : {"SLAVE=TOP.YMIN MASTER=LOW.YMAX PAIRING=SEGMENT",
                                    "SLAVE=LOW.YMAX MASTER=TOP.YMIN PAIRING=SEGMENT",
                                    "SLAVE=TOP.YMIN MASTER=LOW.YMAX PAIRING=NODE",
                                    "SLAVE=LOW.YMAX MASTER=TOP.YMIN PAIRING=NODE"}) {
    for (const std::string mu : {"0", "0.4"}) {
      const std::optional<Solved> solved =
          solve_text(fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=LOW
  $MESH SHAPE=BLOCK TYPE=QUAMC8 X0=0 Y0=0 LX=8 LY=6 NX=8 NY=6
  $NSET NAME=DOWN WHERE=(abs(x-4) < 1e-9) ORDER=(-y)
$ENDNET
$NET NAME=TOP
  $MESH SHAPE=BLOCK TYPE=QUAMC8 X0=0 Y0=6 LX=8 LY=3 NX=8 NY=3
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=LOW.BODY MATERIAL=M STATE=STRESS
$PROPERTY ESET=TOP.BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=Y
  LOW.YMIN
$FREEDOM CLASS=SUPPRESSED DOF=X
  LOW.XMIN
  TOP.XMIN
$CONTACT NAME=PRESSED {}
$CRACK NAME=C PATH=LOW.DOWN A0=3 MU={}
$TIPNET CRACK=C PATCH=NO
$LOAD CASE=F TYPE=PRESSURE
  TOP.YMAX 2
  TOP.XMAX 2
  LOW.XMAX 2
$STEP NAME=S
  LOAD F 1
$END
)",
                                 pairing, mu));
      ASSERT_TRUE(solved) << pairing;
      const double strain = -2.0 * 0.7 / 1000.0;
      for (std::size_t n = 0; n < solved->mesh().node_count(); ++n) {
        const base::Vec3& x = solved->mesh().x[n];
        const base::Vec3 u = solved->u(base::NodeId(n));
        EXPECT_NEAR(u.x(), strain * x.x(), 1e-9 * std::abs(strain) * 9.0);
        EXPECT_NEAR(u.y(), strain * x.y(), 1e-9 * std::abs(strain) * 9.0);
      }
      EXPECT_NEAR(faces(*solved).min_pressure, 2.0, 1e-7);
      EXPECT_NEAR(faces(*solved).max_pressure, 2.0, 1e-7);
      EXPECT_EQ(solved->step().tips[0].K1, 0.0);
    }
  }
}

// A block with a crack that bending closes in part; then another block is mounted on it, and
// pressed.
std::string mounted_on(const std::string& length, const std::string& growth) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=LOW
  $MESH SHAPE=BLOCK TYPE=QUAMC8 X0=0 Y0=0 LX=20 LY=12 NX=20 NY=12
$ENDNET
$NET NAME=TOP
  $MESH SHAPE=BLOCK TYPE=QUAMC8 X0=4 Y0=12 LX=3 LY=3 NX=3 NY=3
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=LOW.BODY MATERIAL=M STATE=STRESS
$PROPERTY ESET=TOP.BODY MATERIAL=M STATE=STRESS
$NSET NAME=HELD WHERE=(x < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  HELD
$FREEDOM CLASS=SUPPRESSED DOF=X
  TOP.XMIN
$CONTACT NAME=ON SLAVE=TOP.YMIN MASTER=LOW.YMAX GAP=0
$CRACK NAME=C NET=LOW A0={} ANGLE=90[deg]
  10 0
$LOAD CASE=BEND TYPE=TRACTION
  LOW.XMAX (y-4) 0
$LOAD CASE=PRESS TYPE=PRESSURE
  TOP.YMAX 1
$STEP NAME=FIRST
  LOAD BEND 1
$STEP NAME=SECOND
  MOUNT ON
$STEP NAME=THIRD
  LOAD PRESS 1
{}$END
)",
                     length, growth);
}

// Each length of a growing crack finds its own contact; what is mounted at the first one keeps what
// it took on there.
TEST(LipContact, GrowsWithMountedParts) {
  for (const std::string mounted : {"EACH", "FIRST"}) {
    const std::optional<Solved> grown = solve_text(
        mounted_on("5", "$GROW LAW=INCREMENT KMAX=THIRD MOUNTED=" + mounted + "\n  5 6.5\n"));
    ASSERT_TRUE(grown);
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
      if (i == 1 && mounted == "FIRST") {
        continue;
      }
      const std::optional<Solved> alone = solve_text(mounted_on(i == 0 ? "5" : "6.5", ""));
      ASSERT_TRUE(alone);
      ASSERT_EQ(alone->step(0).contacts.size(), 2U);
      EXPECT_GT(alone->step(0).contacts[1].closed, 2);
      for (const std::size_t s : {std::size_t{0}, std::size_t{2}}) {
        const results::StepResult& step = grown->run.increments[i].steps[s];
        const double K1 = alone->step(s).tips[0].K1;
        EXPECT_GT(K1, 0.1);
        EXPECT_NEAR(step.tips[0].K1, K1, 1e-7 * K1) << i << ' ' << s;
        EXPECT_NEAR(step.contacts[0].force_on_slave.y(),
                    alone->step(s).contacts[0].force_on_slave.y(), 1e-7);
        EXPECT_EQ(step.contacts[1].closed, alone->step(s).contacts[1].closed);
      }
    }
  }
}

} // namespace
} // namespace spricka
