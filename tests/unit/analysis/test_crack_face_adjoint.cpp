// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/crack_face_plate.hpp"

// Derivatives and error bars of K where the faces of a crack bear on each other.
namespace spricka::test_crack_face_adjoint {
namespace {

using results::Sensitivity;
using results::SensitivityParameter;
using test::plate;
using test::solve_text;
using test::Solved;

// Compression across, and tension or shear growing along the plate; factors of both.
std::string pressed(const std::string& crack, double p, double s, const std::string& more = "") {
  return plate(crack + more, fmt::format(R"($LOAD CASE=PRESS TYPE=TRACTION
  YMAX 0 -1
  YMIN 0 1
$LOAD CASE=SHEAR TYPE=TRACTION
  XMAX 0 1
  XMIN 0 -1
  YMAX 1 0
  YMIN -1 0
$LOAD CASE=BEND TYPE=TRACTION
  YMAX 0 (x)
  YMIN 0 (-x)
$STEP NAME=S
  LOAD PRESS {:.17g}
  LOAD SHEAR {:.17g}
  LOAD BEND  0.7
)",
                                         p, s));
}

const std::string kinked = "$CRACK NAME=C\n  -1 -0.2\n  0.1 0\n  1 0.4\n";
const std::string straight = "$CRACK NAME=C\n  -1 0\n  1 0\n";

const Sensitivity& by(const results::FrontResult& front, SensitivityParameter cause,
                      const std::string& name) {
  for (const Sensitivity& s : front.sensitivities.by_parameter) {
    if (s.cause == cause && s.name == name) {
      return s;
    }
  }
  throw std::runtime_error("no derivative by " + name);
}

// As the mesh has it, which the derivatives are of.
base::Vec2 K_of(const std::string& deck, std::size_t tip) {
  const std::optional<Solved> solved = solve_text(deck);
  EXPECT_TRUE(solved);
  if (!solved) {
    return base::Vec2::Zero();
  }
  const std::array<double, 3> K = solved->step().fronts[tip].single_point().raw_K();
  return {K[0], K[1]};
}

void expect_differences(const std::string& crack, double p, double s) {
  const std::optional<Solved> solved = solve_text(pressed(crack, p, s));
  ASSERT_TRUE(solved);
  ASSERT_TRUE(test::was_closed(*solved));
  for (const std::size_t t : {0U, 1U}) {
    const results::FrontResult& front = solved->step().fronts[t];
    const double size = std::hypot(front.single_point().K1, front.single_point().K2);
    const double h = 1e-4;
    const base::Vec2 by_p =
        (K_of(pressed(crack, p + h, s), t) - K_of(pressed(crack, p - h, s), t)) / (2.0 * h);
    const base::Vec2 by_s =
        (K_of(pressed(crack, p, s + h), t) - K_of(pressed(crack, p, s - h), t)) / (2.0 * h);
    const auto compare = [&](const char* name, const base::Vec2& wanted) {
      const Sensitivity& slope = by(front, SensitivityParameter::load, name);
      ASSERT_TRUE(slope.is_smooth());
      EXPECT_NEAR(slope.below.at(0)[0], wanted[0], 1e-5 * wanted.norm() + 1e-9 * size)
          << front.name << " " << name;
      EXPECT_NEAR(slope.below.at(0)[1], wanted[1], 1e-5 * wanted.norm() + 1e-9 * size)
          << front.name << " " << name;
    };
    compare("PRESS", by_p);
    compare("SHEAR", by_s);
    // stresses do not depend on the modulus of a body that is loaded by forces only
    const Sensitivity& by_E = by(front, SensitivityParameter::modulus, "M");
    ASSERT_TRUE(by_E.is_smooth());
    EXPECT_LT(1000.0 * std::hypot(by_E.below.at(0)[0], by_E.below.at(0)[1]), 1e-7 * size)
        << front.name;
  }
}

TEST(CrackFaceAdjoint, DerivativesOfACrackThatIsClosed) {
  expect_differences(straight, 3.0, 1.0);
  expect_differences(kinked, 3.0, 1.0);
}

TEST(CrackFaceAdjoint, DerivativesOfACrackThatIsClosedInPart) {
  expect_differences(straight, 0.2, 0.3);
  expect_differences(kinked, 0.2, -0.3);
}

// Of K on a mesh and of a finer one, which knows the truth to its own bar.
void expect_inside(const std::string& crack, double p, double s) {
  const std::optional<Solved> coarse =
      solve_text(pressed(crack, p, s, "$TIPNET CRACK=C SIZE=0.2 RADIUS=0.3 RINGS=3 SECTORS=12\n"));
  const std::optional<Solved> fine = solve_text(
      pressed(crack, p, s, "$TIPNET CRACK=C SIZE=0.02 RADIUS=0.3 RINGS=12 SECTORS=48\n"));
  ASSERT_TRUE(coarse && fine);
  for (const std::size_t t : {0U, 1U}) {
    const results::FrontResult& front = coarse->step().fronts[t];
    const results::FrontResult& fine_front = fine->step().fronts[t];
    ASSERT_TRUE(front.missing_bar_reason.empty()) << front.missing_bar_reason;
    ASSERT_TRUE(fine_front.missing_bar_reason.empty()) << fine_front.missing_bar_reason;
    const results::FrontPointResult& tip = front.single_point();
    const results::FrontPointResult& truth = fine_front.single_point();
    const std::array<double, 2> found{tip.K1, tip.K2};
    for (const std::size_t k : {0U, 1U}) {
      const double error = std::abs(truth.bar[k].best - found[k]);
      EXPECT_LE(error, tip.bar[k].size() + truth.bar[k].size()) << front.name << " K" << k + 1;
      EXPECT_LE(tip.bar[k].size(), 0.1 * std::hypot(tip.K1, tip.K2)) << front.name << " K" << k + 1;
    }
    EXPECT_EQ(tip.closed, truth.closed);
    if (tip.closed) {
      EXPECT_EQ(tip.bar[0].size(), 0.0);
    }
  }
}

TEST(CrackFaceAdjoint, BarsOfACrackThatIsClosed) {
  expect_inside(straight, 3.0, 1.0);
  expect_inside(kinked, 3.0, 1.0);
}

TEST(CrackFaceAdjoint, BarsOfACrackThatIsClosedInPart) {
  expect_inside(straight, 0.2, 0.3);
  expect_inside(kinked, 0.2, -0.3);
}

} // namespace
} // namespace spricka::test_crack_face_adjoint
