// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/crack_face_plate.hpp"

namespace spricka::test_crack_face_contact {
namespace {

using test::bent;
using test::faces;
using test::plate;
using test::root_pi;
using test::slant;
using test::solve_text;
using test::Solved;
using test::stressed;
using test::was_closed;

// Hydrostatic pressure closes a crack of any shape, and nothing of it is left: uniform stress, the
// displacement that of the plate without a crack, pressure p at every node of the faces.
TEST(CrackFaceContact, PressureAllRoundLeavesNothingOfACrack) {
  for (const std::string crack :
       {"$CRACK NAME=C\n  -1 0.2\n  1 -0.1\n", "$CRACK NAME=C\n  -2 0\n  0 1\n  2 0.5\n",
        "$CRACK NAME=C LINE=SMOOTH\n  -2 0\n  0 1\n  2 0\n",
        "$CRACK NAME=C\n  -20 1\n  -15 1.5\n"}) {
    const std::optional<Solved> solved = solve_text(plate(crack, stressed(-2.0, -2.0, 0.0)));
    ASSERT_TRUE(solved);
    const double strain = -2.0 * 0.7 / 1000.0;
    for (std::size_t n = 0; n < solved->mesh().node_count(); ++n) {
      if (!model::mark_nodes_in_use(solved->mesh())[n]) {
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
    for (const results::FrontResult& front : solved->step().fronts) {
      const results::FrontPointResult& tip = front.single_point();
      EXPECT_EQ(tip.K1, 0.0);
      EXPECT_NEAR(tip.K2, 0.0, 1e-6);
      EXPECT_NEAR(tip.T, -2.0, 0.02) << crack;
      EXPECT_TRUE(tip.closed);
      EXPECT_TRUE(front.invalid_reason.empty());
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
  EXPECT_EQ(cracked->step().fronts.front().single_point().K1, 0.0);
  EXPECT_EQ(cracked->step().fronts.front().single_point().K2, 0.0);
}

// Faces that friction holds everywhere are no crack.
TEST(CrackFaceContact, FacesThatStickAreNoCrack) {
  const std::string crack =
      "$CRACK NAME=C PATH=LINE A0=4 MU=5\n$TIPNET CRACK=C PATCH=NO QUARTER=NO\n";
  expect_same_bodies(crack, "YMAX (0.2+0.1*x) (-2-x)");
  expect_same_bodies(crack, "YMAX 0 (-9-0.1*x*x)");
}

// A crack on the line of symmetry, as a whole body and as either half of it, opening at its tip
// and closed at its mouth.
TEST(CrackFaceContact, HalvesAreTheWhole) {
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
    EXPECT_NEAR(half->step().fronts[0].single_point().K1, whole->step().fronts[0].single_point().K1,
                1e-8);
    EXPECT_GT(half->step().fronts[0].single_point().K1, 1.0);
    EXPECT_TRUE(half->step().fronts[0].invalid_reason.empty());
  }
}

// F11: closed from -a to c = -a/3 - 4 r a/3, K of the open part of half length b = 2 (1 + r) a/3.
TEST(CrackFaceContact, ClosesInPartUnderBending) {
  for (const double r : {-0.9, -0.5, 0.0, 0.1, 0.4}) {
    const std::optional<Solved> solved = solve_text(bent(r));
    ASSERT_TRUE(solved);
    const double b = 2.0 * (1.0 + r) / 3.0;
    const double K = b * std::sqrt(std::numbers::pi * b);
    EXPECT_EQ(solved->step().fronts[0].single_point().K1, 0.0);
    EXPECT_TRUE(solved->step().fronts[0].single_point().closed);
    EXPECT_FALSE(solved->step().fronts[1].single_point().closed);
    EXPECT_NEAR(solved->step().fronts[1].single_point().K1, K, 0.005 * K) << r;
    EXPECT_NEAR(faces(*solved).arc_to, 2.0 - 2.0 * b, 0.02) << r;
    EXPECT_TRUE(solved->step().fronts[1].invalid_reason.empty());
  }
}

TEST(CrackFaceContact, OpenFacesCostNothing) {
  const std::optional<Solved> contact = solve_text(bent(0.6, "FACES=CONTACT MU=0.3"));
  const std::optional<Solved> free = solve_text(bent(0.6, "FACES=FREE"));
  ASSERT_TRUE(contact && free);
  EXPECT_TRUE(contact->step().u == free->step().u);
  EXPECT_EQ(contact->step().fronts[1].single_point().K1, free->step().fronts[1].single_point().K1);
  EXPECT_EQ(contact->run.log.size(), free->run.log.size());
  EXPECT_TRUE(contact->step().contacts.empty());
  for (const std::string& note : results::text_with_code(contact->step().notes)) {
    EXPECT_EQ(note.find("faces"), std::string::npos) << note;
  }
  EXPECT_NEAR(contact->step().fronts[0].single_point().K1, 0.1 * root_pi, 0.01);
}

TEST(CrackFaceContact, OpensEverywhereOrNowhere) {
  const std::optional<Solved> shut = solve_text(bent(-1.2));
  ASSERT_TRUE(shut);
  for (const results::FrontResult& front : shut->step().fronts) {
    const results::FrontPointResult& tip = front.single_point();
    EXPECT_EQ(tip.K1, 0.0);
    EXPECT_TRUE(tip.closed);
    EXPECT_NEAR(tip.K2, 0.0, 1e-6);
  }
  EXPECT_EQ(faces(*shut).closed, faces(*shut).rows);
}

// K2 = -(tau - mu sigma_n) sqrt(pi a) by slip, at any angle of the crack; the same on all rings,
// though the shear of the faces is not the same on all of them.
TEST(CrackFaceContact, SlipsAgainstFriction) {
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
        const results::LoadStepResult& step = solved->step();
        K2.push_back(step.fronts[1].single_point().K2);
        EXPECT_NEAR(step.fronts[0].single_point().K2, step.fronts[1].single_point().K2, 1e-4);
        EXPECT_EQ(step.fronts[1].single_point().K1, 0.0);
        ASSERT_EQ(step.fronts[1].single_point().K1_domain.size(), 1U);
        EXPECT_NEAR(step.fronts[1].single_point().K1_domain[0], 0.0, 1e-3);
        EXPECT_NEAR(step.fronts[1].single_point().G, step.fronts[1].single_point().G_from_K,
                    1e-3 * step.fronts[1].single_point().G);
        const results::ContactResult& crack_face = faces(*solved);
        EXPECT_LE(crack_face.shear_ratio, 1.0 + 1e-9);
        EXPECT_NEAR(crack_face.min_pressure, sn, 0.005);
        EXPECT_GE(crack_face.friction_work, 0.0);
        for (const results::ForceBalance& body : step.balance) { // equal and opposite
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
TEST(CrackFaceContact, MirroredAndTurnedCracksAgree) {
  const auto solve = [](double angle, double sx, double sy) {
    return solve_text(plate(slant(angle, "MU=0.2"), stressed(sx, sy, 0.0)));
  };
  const double angle = 0.7;
  const std::optional<Solved> plain = solve(angle, 0.0, -1.0);
  const std::optional<Solved> mirrored = solve(-angle, 0.0, -1.0);
  const std::optional<Solved> turned = solve(angle + 0.5 * std::numbers::pi, -1.0, 0.0);
  ASSERT_TRUE(plain && mirrored && turned);
  const double K2 = plain->step().fronts[1].single_point().K2;
  EXPECT_NEAR(mirrored->step().fronts[1].single_point().K2, -K2, 1e-4 * std::abs(K2));
  EXPECT_NEAR(turned->step().fronts[1].single_point().K2, K2, 1e-4 * std::abs(K2));
}

// Energy of two lengths: G = dU/da for dead loads, per tip, with the faces partly or wholly closed
// and free to slip. The patch follows the length, so that its mesh does not change.
TEST(CrackFaceContact, EnergyReleaseIsThatOfTheEnergy) {
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
    const double G = at->step().fronts[0].single_point().G + at->step().fronts[1].single_point().G;
    EXPECT_NEAR(G, differenced, 0.01 * G);
    EXPECT_NEAR(G,
                at->step().fronts[0].single_point().G_from_K +
                    at->step().fronts[1].single_point().G_from_K,
                2e-3 * G);
  }
}

// Loaded, relieved and loaded again: the closed form of decks/closed_crack_cycle.deck, in steps of
// any size.
TEST(CrackFaceContact, RemembersSlip) {
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
      EXPECT_NEAR(solved->step(s).fronts[0].single_point().K2, -exact[s] * root_pi, 0.005 * root_pi)
          << s;
      EXPECT_EQ(solved->step(s).fronts[0].single_point().K1, 0.0);
    }
    EXPECT_NEAR(solved->step(1).fronts[0].single_point().K2,
                solved->step(0).fronts[0].single_point().K2, 1e-8);
  }
}

TEST(CrackFaceContact, ThreadsChangeNoBit) {
  const std::string deck = plate(slant(0.6, "MU=0.2"), stressed(0.3, -1.0, 0.1));
  const std::optional<Solved> one = solve_text(deck, 1);
  const std::optional<Solved> four = solve_text(deck, 4);
  ASSERT_TRUE(one && four);
  EXPECT_TRUE(was_closed(*one));
  EXPECT_TRUE(one->step().u == four->step().u);
  EXPECT_EQ(one->step().fronts[0].single_point().K2, four->step().fronts[0].single_point().K2);
}

} // namespace
} // namespace spricka::test_crack_face_contact
