// SPDX-License-Identifier: GPL-3.0-or-later
// Faces of cracks in space that bear on each other.
#include "analysis/recover/gather_fronts.hpp"
#include "analysis/scene/front_surroundings.hpp"
#include "analysis/steps/crack_face_contact.hpp"
#include "analysis/steps/solid_face_contact.hpp"
#include "crack/front_intensity.hpp"
#include "tests/places.hpp"
#include "tests/unit/support/solved_scene.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace spricka::test_solid_face_contact {
namespace {

using test::solve_text;
using test::Solved;
using test::SolvedScene;

// Of the tube round the front: fine with SPRICKA_FULL, else half as many elements.
const double radius = test::full_size() ? 0.2 : 0.3;

// A penny of radius 1 in a block of half width 8, pressed by uniform stress on all sides or on two.
std::string penny(const std::string& crack, const std::string& steps) {
  return R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=B
  $MESH SHAPE=BLOCK TYPE=TET10 X0=-8 Y0=-8 Z0=-8 LX=16 LY=16 LZ=16 NX=3 NY=3 NZ=3
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=B.BODY MATERIAL=M STATE=SOLID
$NSET NAME=P1 WHERE=(x < -7.99 and y < -7.99 and z < -7.99)
$NSET NAME=P2 WHERE=(x > 7.99 and y < -7.99 and z < -7.99)
$NSET NAME=P3 WHERE=(x < -7.99 and y > 7.99 and z < -7.99)
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  P1
$FREEDOM CLASS=SUPPRESSED DOF=YZ
  P2
$FREEDOM CLASS=SUPPRESSED DOF=Z
  P3
$CRACK NAME=C NET=B A=1 X0=0 Y0=0 Z0=0 NORMAL=Z )" +
         crack + fmt::format("\n$TIPNET CRACK=C RADIUS={} RINGS=3", radius) + R"(
$LOAD CASE=UP TYPE=TRACTION
  B.ZMAX 0 0 1
  B.ZMIN 0 0 -1
$LOAD CASE=ROUND TYPE=TRACTION
  B.XMAX 1 0 0
  B.XMIN -1 0 0
  B.YMAX 0 1 0
  B.YMIN 0 -1 0
$LOAD CASE=SHEAR TYPE=TRACTION
  B.ZMAX 1 0 0
  B.ZMIN -1 0 0
  B.XMAX 0 0 1
  B.XMIN 0 0 -1
$LOAD CASE=RIM TYPE=FACES
  C (2*(x*x + y*y) - 1)
$LOAD CASE=BEND TYPE=FACES
  C (0.2 + x)
)" + steps +
         "$END\n";
}

constexpr double k_shear = 4.0 / 1.7 * 0.5641895835477563; // 4 sqrt(pi) / (pi (2 - nu))

const results::ContactResult& faces_of(const results::LoadStepResult& step) {
  const results::ContactResult* found = results::find_contact(step, "C.FACES");
  EXPECT_NE(found, nullptr);
  static const results::ContactResult none{};
  return found == nullptr ? none : *found;
}

bool tells_of(const std::vector<results::Note>& notes, const std::string& words) {
  return std::ranges::any_of(results::text_with_code(notes), [&](const std::string& note) {
    return note.find(words) != std::string::npos;
  });
}

bool tells(const results::LoadStepResult& step, const std::string& words) {
  return tells_of(step.notes, words);
}

// Hydrostatic pressure leaves nothing of the crack: the strain of the body without it at all nodes,
// its pressure at all nodes of the faces, as far as the diagonals know a uniform strain where two
// triangles meet one quadrilateral.
TEST(SolidFaceContact, PressureAllRoundLeavesNothingOfACrack) {
  const auto solved = solve_text(penny("", "$STEP NAME=S\n  LOAD UP -2\n  LOAD ROUND -2\n"));
  ASSERT_TRUE(solved);
  const double strain = -2.0 * 0.4 / 1000.0;
  const std::vector<bool> used = model::mark_nodes_in_use(solved->mesh());
  for (std::size_t n = 0; n < used.size(); ++n) {
    const base::Vec3 exact = strain * (solved->mesh().x[n] + base::Vec3::Constant(8.0));
    EXPECT_LT(used[n] ? (solved->u(base::NodeId(n)) - exact).norm() : 0.0, 3e-4 * 16.0 * 8e-4);
  }
  for (const results::ContactPoint& p : faces_of(solved->step()).points) {
    EXPECT_NEAR(p.p_consistent, 2.0, 0.03);
    EXPECT_TRUE(p.closed);
  }
  for (const results::FrontPointResult& place : solved->step().fronts.front().points) {
    EXPECT_TRUE(place.closed);
    EXPECT_EQ(place.K1, 0.0);
    EXPECT_NEAR(place.K2, 0.0, 1e-3); // of 2 sqrt(a/pi) p = 2.3
    EXPECT_NEAR(place.K3, 0.0, 1e-3);
    EXPECT_NEAR(place.T, -2.0, 0.04);
  }
  EXPECT_TRUE(solved->step().fronts.front().invalid_reason.empty());
}

// Friction that holds the faces everywhere leaves nothing of it either.
TEST(SolidFaceContact, FacesThatStickAreNoCrack) {
  const auto solved =
      solve_text(penny("MU=1", "$STEP NAME=S SUBSTEPS=1\n  LOAD UP -1\n  LOAD SHEAR 0.5\n"));
  ASSERT_TRUE(solved);
  for (const results::FrontPointResult& place : solved->step().fronts.front().points) {
    EXPECT_TRUE(place.closed);
    EXPECT_EQ(place.K1, 0.0);
    EXPECT_EQ(place.K2, 0.0);
    EXPECT_EQ(place.K3, 0.0);
    EXPECT_EQ(place.G, 0.0);
  }
  EXPECT_NEAR(faces_of(solved->step()).max_pressure, 1.0, 0.02);
}

// The same K, with pressure and friction of the faces left out of the integrals.
std::vector<crack::StressIntensity> without_faces(const SolvedScene& solved,
                                                  const analysis::StepState& state) {
  const mesh::CrackedMesh& cracked = solved.scene().cracked;
  const crack::FrontIntegralDomains& domains = solved.scene().domains.front();
  const crack::FrontLoads loads =
      analysis::collect_front_loads(solved.model(), solved.scene(), domains, state.case_factor);
  return crack::front_intensity(solved.model(), cracked, cracked.fronts.front(), domains, {},
                                state.u, loads);
}

const SolvedScene::Changes closed_from_the_start{
    .model = {}, .scene = [](analysis::Discretisation& scene, const model::Model& model) {
      analysis::add_crack_face_pairs(model, {0}, scene);
    }};

// D04: slip against friction, K2 and K3 of the shear that is left; without the tractions of the
// faces in the integrals both are far off.
TEST(SolidFaceContact, SlipsAgainstFriction) {
  SolvedScene solved(penny("MU=0.3", "$STEP NAME=S SUBSTEPS=1\n  LOAD UP -1\n  LOAD SHEAR 0.5\n"),
                     closed_from_the_start);
  const auto state = solved.solve(0);
  ASSERT_TRUE(state);
  const results::LoadStepResult found =
      solved.length->recover_step(solved.model().steps[0], *state);
  const double k = 0.2 * k_shear;
  const auto rough = without_faces(solved, *state);
  double K2_off = 0.0;
  double K3_off = 0.0;
  for (std::size_t i = 0; i < rough.size(); ++i) {
    const results::FrontPointResult& place = found.fronts.front().points[i];
    EXPECT_TRUE(place.closed);
    EXPECT_EQ(place.K1, 0.0);
    EXPECT_NEAR(place.K2, k * std::cos(place.phi), 0.02 * k);
    EXPECT_NEAR(place.K3, 0.7 * k * std::sin(place.phi), 0.025 * k);
    EXPECT_NEAR(place.G, place.G_from_K, 0.03 * k * k / 1000.0);
    K2_off = std::max(K2_off, std::abs(rough[i].K2 - place.K2));
    K3_off = std::max(K3_off, std::abs(rough[i].K3 - place.K3));
  }
  EXPECT_GT(K2_off, 0.3 * k);
  EXPECT_GT(K3_off, 0.3 * k);
  const results::ContactResult& faces = faces_of(found);
  EXPECT_LE(faces.shear_ratio, 1.0 + 1e-9);
  EXPECT_NEAR(faces.mean_pressure, 1.0, 5e-3);
  for (const results::ForceBalance& body : found.balance) { // equal and opposite
    EXPECT_LT(body.contact.norm(), 1e-9);
  }
}

// D05: closed in its middle; faces that overlap, and K without the pressure between them, are far
// off.
TEST(SolidFaceContact, ClosesInItsMiddle) {
  SolvedScene solved(penny("", "$STEP NAME=S\n  LOAD RIM 1\n"), closed_from_the_start);
  const auto state = solved.solve(0);
  ASSERT_TRUE(state);
  const results::LoadStepResult found =
      solved.length->recover_step(solved.model().steps[0], *state);
  for (const results::FrontPointResult& place : found.fronts.front().points) {
    EXPECT_NEAR(place.K1, 0.4975, 0.02 * 0.4975);
    EXPECT_FALSE(place.closed);
  }
  EXPECT_NEAR(std::sqrt(faces_of(found).area / std::numbers::pi), 0.587, 0.06);
  const auto open = solve_text(penny("FACES=FREE", "$STEP NAME=S\n  LOAD RIM 1\n"));
  ASSERT_TRUE(open);
  EXPECT_NEAR(open->step().fronts.front().points.front().K1, 0.376, 0.02);
  EXPECT_TRUE(open->step().fronts.front().invalid_reason.empty()); // it opens at the front
  EXPECT_TRUE(tells(open->step(), "overlap"));
}

// A front that is closed along a part of it: the energy of two radii is that of G along it, and G
// that of K.
TEST(SolidFaceContact, ClosesAlongAPartOfTheFront) {
  const auto solve = [](const std::string& a) {
    std::string deck = penny("", "$STEP NAME=S\n  LOAD BEND 1\n");
    return solve_text(deck.replace(deck.find("A=1 "), 4, "A=" + a + " "));
  };
  const auto less = solve("0.98");
  const auto at = solve("1");
  const auto more = solve("1.02");
  ASSERT_TRUE(less && at && more);
  const results::FrontResult& front = at->step().fronts.front();
  EXPECT_TRUE(front.invalid_reason.empty());
  double released = 0.0;
  double of_K = 0.0;
  std::size_t closed = 0;
  const std::size_t count = front.points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const results::FrontPointResult& place = front.points[i];
    const double ahead = i + 1 < count ? front.points[i + 1].s : front.length;
    const double behind = i > 0 ? front.points[i - 1].s : front.points.back().s - front.length;
    released += 0.5 * (ahead - behind) * place.G;
    of_K += 0.5 * (ahead - behind) * place.G_from_K;
    closed += place.closed ? 1 : 0;
    EXPECT_TRUE(place.closed || place.x.x() > -0.55) << place.x.x();
    EXPECT_TRUE(!place.closed || place.x.x() < -0.15) << place.x.x();
    EXPECT_EQ(place.K1 == 0.0, place.closed);
  }
  EXPECT_GT(closed, 0U);
  const double differenced = (more->step().energy - less->step().energy) / 0.04;
  EXPECT_NEAR(released, differenced, 0.01 * differenced);
  EXPECT_NEAR(of_K, differenced, 0.02 * differenced);
}

// Where faces bear on each other K1 is 0 without an error and without a derivative, on a load path
// that closes a part of the front, too: K is that of the steps at its ends, and of steps in between
// as far as the error bars of both go.
TEST(SolidFaceContact, KnowsClosedPointsOnPathsAndInBars) {
  std::string steps;
  for (int k = 0; k <= 2; ++k) {
    steps += fmt::format("$STEP NAME=S{}\n  LOAD UP {}\n  LOAD BEND 1\n", k, 1.0 - 0.5 * k);
  }
  const auto solved = solve_text(penny("", steps + "$LOADPATH NAME=DOWN FROM=S0 TO=S2\n"));
  ASSERT_TRUE(solved);
  const results::CrackLengthResult& increment = solved->run.increments.front();
  const results::LoadPathResult& path = increment.paths.front();
  EXPECT_LT(path.mismatch, 1e-6);
  EXPECT_TRUE(tells_of(path.notes, "touch at"));
  std::size_t closed = 0;
  for (std::size_t s = 0; s < increment.steps.size(); ++s) {
    const results::FrontResult& own = increment.steps[s].fronts[0];
    const results::FrontResult found = path.fronts[0].at(0.5 * static_cast<double>(s));
    ASSERT_TRUE(own.missing_bar_reason.empty()) << own.missing_bar_reason;
    for (std::size_t i = 0; i < own.points.size(); ++i) {
      const results::FrontPointResult& place = own.points[i];
      const std::array<double, 3> K = found.points[i].K();
      for (std::size_t mode = 0; mode < 3; ++mode) {
        EXPECT_NEAR(mode == 0 ? std::max(0.0, K[mode]) : K[mode], place.K()[mode],
                    1e-6 + (s == 1 ? 2.0 * place.bar[mode].size() : 0.0))
            << s << " point " << i << " mode " << mode + 1;
      }
      EXPECT_EQ(place.bar[0].size() == 0.0, place.closed) << s << " point " << i;
      EXPECT_EQ(place.bar[0].best == 0.0, place.closed);
      for (const results::Sensitivity& cause : own.sensitivities.by_parameter) {
        EXPECT_TRUE(!place.closed || cause.below[i][0] == 0.0) << cause.name;
        EXPECT_TRUE(place.closed || place.at_surface || cause.name != "UP" ||
                    cause.below[i][0] > 0.0);
      }
      closed += place.closed ? 1 : 0;
    }
  }
  EXPECT_GT(closed, 0U);
}

// Pulled, pressed and pulled again: faces close and open again, and what friction did is gone.
TEST(SolidFaceContact, OpensAgain) {
  const auto solved = solve_text(penny(
      "", "$STEP NAME=A\n  LOAD UP 1\n$STEP NAME=B\n  LOAD UP -1\n$STEP NAME=C\n  LOAD UP 1\n"));
  ASSERT_TRUE(solved);
  const auto& first = solved->step(0).fronts.front().points;
  const auto& last = solved->step(2).fronts.front().points;
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_NEAR(first[i].K1, last[i].K1, 1e-9);
    EXPECT_FALSE(first[i].closed);
    EXPECT_TRUE(solved->step(1).fronts.front().points[i].closed);
  }
  EXPECT_EQ(faces_of(solved->step(0)).closed, 0);
}

// Faces that may not bear: told, and K1 < 0 is no answer.
TEST(SolidFaceContact, TellsFreeFacesThatOverlap) {
  const auto solved = solve_text(penny("FACES=FREE", "$STEP NAME=S\n  LOAD UP -1\n"));
  ASSERT_TRUE(solved);
  EXPECT_FALSE(solved->step().fronts.front().invalid_reason.empty());
  EXPECT_TRUE(tells(solved->step(), "overlap"));
  EXPECT_TRUE(solved->step().contacts.empty());
}

// Open faces are no pair and change no bit.
TEST(SolidFaceContact, OpenFacesCostNothing) {
  const std::string pull = "$STEP NAME=S\n  LOAD UP 1\n  LOAD SHEAR 0.3\n";
  const auto contact = solve_text(penny("MU=0.3", pull));
  const auto free = solve_text(penny("FACES=FREE", pull));
  ASSERT_TRUE(contact && free);
  EXPECT_TRUE(contact->step().u == free->step().u);
  EXPECT_TRUE(contact->step().contacts.empty());
  EXPECT_EQ(contact->run.log.size(), free->run.log.size());
}

TEST(SolidFaceContact, ThreadsChangeNoBit) {
  if (!test::full_size()) {
    GTEST_SKIP() << "at full size; threads: front_analysis.front_invariance";
  }
  const std::string deck =
      penny("MU=0.2", "$STEP NAME=S SUBSTEPS=1\n  LOAD UP -1\n  LOAD SHEAR 0.5\n");
  const auto one = solve_text(deck, 1);
  const auto two = solve_text(deck, 2);
  ASSERT_TRUE(one && two);
  EXPECT_TRUE(one->step().u == two->step().u);
  EXPECT_EQ(one->step().fronts.front().points[0].K2, two->step().fronts.front().points[0].K2);
}

} // namespace
} // namespace spricka::test_solid_face_contact
