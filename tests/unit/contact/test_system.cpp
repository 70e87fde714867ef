// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/system.hpp"

#include <random>

#include <Eigen/LU>

#include <gtest/gtest.h>

namespace spricka {
namespace {

// A body of two freedoms x, y at node 0 that floats in x and is held in y by a spring of 4.
TEST(CondensedBody, PseudoInverseLeavesTheFreeModeOut) {
  base::Matrix modes(2, 1);
  modes << 3.0, 0.0;
  const contact::CondensedBody body({0, 1}, base::Vector(Eigen::Vector2d(0.0, 4.0)).asDiagonal(),
                                    modes);
  ASSERT_TRUE(body.ok());
  base::Matrix F(2, 1);
  F << 5.0, 2.0;
  const base::Matrix u = body.displacement(F);
  EXPECT_NEAR(u(0, 0), 0.0, 1e-14);
  EXPECT_NEAR(u(1, 0), 0.5, 1e-14);
}

TEST(CondensedBody, PseudoInverseOfARandomSemidefiniteMatrix) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  base::Matrix A = base::Matrix::NullaryExpr(6, 9, [&] { return value(random); });
  base::Matrix modes = base::Matrix::NullaryExpr(6, 2, [&] { return value(random); });
  // Rows of A made orthogonal to the modes: S = A A^T then has exactly these in its null space.
  const base::Matrix N = modes * (modes.transpose() * modes).inverse() * modes.transpose();
  A -= N * A;
  const base::Matrix S = A * A.transpose();
  const contact::CondensedBody body({0, 1, 2, 3, 4, 5}, S, modes);
  const base::Matrix F = base::Matrix::NullaryExpr(6, 3, [&] { return value(random); });
  const base::Matrix u = body.displacement(F);
  EXPECT_LT((S * u - (F - N * F)).norm(), 1e-12);
  EXPECT_LT((modes.transpose() * u).norm(), 1e-12);
  const base::Matrix Y = body.half_compliance(F);
  EXPECT_LT((Y.transpose() * Y - F.transpose() * u).norm(), 1e-12);
}

// Two free masses on a line pressed together by opposite forces, one row between them: the force
// in the row is the load, whatever the modes do; a net force on both is refused.
TEST(ContactSystem, FloatingBodiesAreHeldByContactAlone) {
  base::Matrix S = base::Matrix::Zero(1, 1);
  base::Matrix mode = base::Matrix::Ones(1, 1);
  const contact::CondensedBody left({0}, S, mode);
  const contact::CondensedBody right({2}, base::Matrix::Constant(1, 1, 8.0),
                                     base::Matrix::Zero(1, 0));
  contact::ConstraintRow row;
  row.entries = {{base::NodeId(std::size_t{0}), {-1.0, 0.0, 0.0}},
                 {base::NodeId(std::size_t{1}), {1.0, 0.0, 0.0}}};
  row.gap = 0.25;
  const contact::ContactSystem system({&left, &right}, {&row}, 2, 4);
  contact::ContactSystem::Demand demand;
  demand.rows = {0};
  demand.equality = {false};
  demand.gap = base::Vector::Constant(1, row.gap);
  demand.load = {base::Vector::Constant(1, 2.0), base::Vector::Zero(1)};
  demand.load_scale = 2.0;
  const contact::ContactSystem::Answer pressed = system.solve(demand, {});
  ASSERT_EQ(pressed.solution.status, solve::ContactStatus::solved);
  EXPECT_NEAR(pressed.solution.lambda[0], 2.0, 1e-13);
  EXPECT_NEAR(pressed.u[1][0], 0.25, 1e-13);
  EXPECT_NEAR(pressed.u[0][0], 0.5, 1e-13);
  demand.load[0][0] = -2.0; // pulls away: nothing holds the left mass
  EXPECT_EQ(system.solve(demand, {}).solution.status, solve::ContactStatus::unheld_mode);
}

} // namespace
} // namespace spricka
