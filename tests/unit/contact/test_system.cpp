// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/held_contact.hpp"
#include "contact/system.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <random>

#include <Eigen/LU>

#include <gtest/gtest.h>

namespace spricka::test_system {
namespace {

// A body of two freedoms x, y at node 0 that floats in x and is held in y by a spring of 4.
TEST(CondensedBody, PseudoInverseLeavesTheFreeModeOut) {
  base::Matrix modes(2, 1);
  modes << 3.0, 0.0;
  const contact::CondensedBody body({0, 1}, base::Vector(Eigen::Vector2d(0.0, 4.0)).asDiagonal(),
                                    modes);
  ASSERT_TRUE(body.is_factorised());
  base::Matrix F(2, 1);
  F << 5.0, 2.0;
  const base::Matrix u = body.displacements_under_forces(F);
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
  const base::Matrix u = body.displacements_under_forces(F);
  EXPECT_LT((S * u - (F - N * F)).norm(), 1e-12);
  EXPECT_LT((modes.transpose() * u).norm(), 1e-12);
  const base::Matrix Y = body.compliance_root(F);
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
  contact::ContactSystem::IncrementProblem problem;
  problem.rows = {0};
  problem.equality = {false};
  problem.gap = base::Vector::Constant(1, row.gap);
  problem.load = {base::Vector::Constant(1, 2.0), base::Vector::Zero(1)};
  problem.load_scale = 2.0;
  const contact::ContactSystem::IncrementSolution pressed = system.solve(problem, {});
  ASSERT_EQ(pressed.contact.status, solve::ContactStatus::solved);
  EXPECT_NEAR(pressed.contact.lambda[0], 2.0, 1e-13);
  EXPECT_NEAR(pressed.u[1][0], 0.25, 1e-13);
  EXPECT_NEAR(pressed.u[0][0], 0.5, 1e-13);
  problem.load[0][0] = -2.0; // pulls away: nothing holds the left mass
  EXPECT_EQ(system.solve(problem, {}).contact.status, solve::ContactStatus::unheld_mode);
}

// Rows that last: the same compliance as without, and the same bits whether kept or made anew.
TEST(ContactSystem, LastingRowsChangeNoBit) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  const base::Matrix A = base::Matrix::NullaryExpr(8, 12, [&] { return value(random); });
  const contact::CondensedBody body({0, 1, 2, 3, 4, 5, 6, 7}, A * A.transpose(),
                                    base::Matrix(8, 0));
  std::vector<contact::ConstraintRow> rows(4);
  std::vector<const contact::ConstraintRow*> all;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    rows[r].node = base::NodeId(3 - r);
    rows[r].entries = {{base::NodeId(r), {value(random), value(random), 0.0}}};
    all.push_back(&rows[r]);
  }
  const contact::ContactSystem plain({&body}, all, 2, 8);
  contact::PersistentRowCompliance kept;
  const contact::PersistentRowSet lasting{{true, false, true, true}, {&kept}};
  const contact::ContactSystem made({&body}, all, 2, 8, {}, lasting);
  EXPECT_EQ(kept.rows.size(), 3U);
  EXPECT_LT((made.row_compliance_matrix() - plain.row_compliance_matrix()).norm(),
            1e-13 * plain.row_compliance_matrix().norm());
  rows[1].entries[0].weight.x() = 0.5; // what does not last may change
  const contact::ContactSystem taken({&body}, all, 2, 8, {}, lasting);
  contact::PersistentRowCompliance none;
  const contact::ContactSystem anew({&body}, all, 2, 8, {}, {{true, false, true, true}, {&none}});
  EXPECT_EQ((taken.row_compliance_matrix() - anew.row_compliance_matrix()).cwiseAbs().maxCoeff(),
            0.0);
  rows[0].entries[0].weight.x() = 0.25; // a row that was to last did not
  const contact::ContactSystem other({&body}, all, 2, 8, {}, lasting);
  const contact::ContactSystem other_plain({&body}, all, 2, 8);
  EXPECT_LT((other.row_compliance_matrix() - other_plain.row_compliance_matrix()).norm(),
            1e-13 * other_plain.row_compliance_matrix().norm());
}

// A body that comes as a factor: rows on its early rows last although the body does not.
TEST(ContactSystem, RowsOnEarlyRowsLastFromBodyToBody) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  const auto positive = [&](Eigen::Index n) {
    const base::Matrix A = base::Matrix::NullaryExpr(n, n + 4, [&] { return value(random); });
    return base::Matrix(A * A.transpose());
  };
  // A block of 4 early and 2 late rows; the late ones lie in the body's own matrix of 6 rows, of
  // which the last 4 are external.
  const base::Matrix block = positive(6);
  const auto early = std::make_shared<const solve::FirstBlockFactor>(
      block, solve::EarlyLateRowPartition{{0, 1, 2, 3}, {4, 5}});
  std::vector<contact::ConstraintRow> rows(4);
  std::vector<const contact::ConstraintRow*> all;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    rows[r].node = base::NodeId(r);
    rows[r].entries = {{base::NodeId(r), {value(random), value(random), 0.0}}};
    all.push_back(&rows[r]);
  }
  contact::PersistentRowCompliance kept;
  for (int length = 0; length < 3; ++length) {
    const base::Matrix own = positive(6);
    base::Matrix whole = base::Matrix::Zero(10, 10);
    whole.bottomRightCorner(6, 6) = own;
    whole.topLeftCorner(6, 6) += block;
    base::Matrix D = own;
    D.topLeftCorner(2, 2) += early->schur();
    const std::vector<Eigen::Index> row{0, 1, 2, 3, 6, 7, 8, 9};
    const contact::CondensedBody body({0, 1, 2, 3, 4, 5, 6, 7},
                                      {solve::TwoBlockCholesky(early, {0, 1}, D), row});
    ASSERT_TRUE(body.is_factorised());
    const base::Matrix S = base::Matrix(whole.inverse()(row, row)).inverse();
    const contact::CondensedBody plain_body({0, 1, 2, 3, 4, 5, 6, 7}, S, base::Matrix(8, 0));
    const contact::ContactSystem plain({&plain_body}, all, 2, 8);
    const contact::ContactSystem kept_rows({&body}, all, 2, 8, {},
                                           {{true, true, true, false}, {&kept}});
    EXPECT_EQ(kept.rows.size(), 2U); // row 2 would last, but its freedoms are not early
    EXPECT_LT((kept_rows.row_compliance_matrix() - plain.row_compliance_matrix()).norm(),
              1e-11 * plain.row_compliance_matrix().norm());
    contact::PersistentRowCompliance none;
    const contact::ContactSystem anew({&body}, all, 2, 8, {}, {{true, true, true, false}, {&none}});
    EXPECT_EQ(
        (kept_rows.row_compliance_matrix() - anew.row_compliance_matrix()).cwiseAbs().maxCoeff(),
        0.0);
    const base::Matrix F = base::Matrix::NullaryExpr(8, 2, [&] { return value(random); });
    const base::Matrix u = plain_body.displacements_under_forces(F);
    EXPECT_LT((body.displacements_under_forces(F) - u).norm(), 1e-11 * u.norm());
  }
}

// Three springs in a row between walls, pairs between them: a pivot is the compliance of a row as
// long as others hold, and what holding the row itself takes is the inverse of that.
TEST(ContactSystem, PivotsOfHeldRowsAreInversesOfThoseOfOpenOnes) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  const base::Matrix A = base::Matrix::NullaryExpr(6, 9, [&] { return value(random); });
  const contact::CondensedBody body({0, 1, 2, 3, 4, 5}, A * A.transpose(), base::Matrix(6, 0));
  const contact::CondensedBody other(
      {6, 8}, (base::Matrix(2, 2) << 3.0, -3.0, -3.0, 3.0).finished(), base::Matrix::Ones(2, 1));
  std::vector<contact::ConstraintRow> rows(4);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    rows[r].entries = {{base::NodeId(r % 3), {value(random), value(random), 0.0}},
                       {base::NodeId(3 + r % 2), {value(random), 0.0, 0.0}}};
  }
  const contact::ContactSystem system({&body, &other}, {&rows[0], &rows[1], &rows[2], &rows[3]}, 2,
                                      10);
  const std::vector<std::size_t> held{0, 1, 3};
  for (const std::size_t i : {std::size_t{1}, std::size_t{3}}) {
    std::vector<std::size_t> without;
    std::ranges::copy_if(held, std::back_inserter(without), [&](std::size_t r) { return r != i; });
    const base::Vector closed = contact::FixedActiveSet(system, held).row_pivots({i});
    const base::Vector open = contact::FixedActiveSet(system, without).row_pivots({i});
    ASSERT_EQ(closed.size(), 1);
    ASSERT_EQ(open.size(), 1);
    EXPECT_GT(open[0], 0.0);
    EXPECT_NEAR(closed[0] * open[0], 1.0, 1e-10);
  }
  // A unit force of the open row moves it by its pivot.
  base::Matrix force = base::Matrix::Zero(6, 1);
  force.col(0).segment<2>(4) = rows[2].entries[0].weight.head<2>();
  base::Matrix on_other = base::Matrix::Zero(2, 1);
  on_other(0, 0) = rows[2].entries[1].weight.x();
  const contact::FixedActiveSet fixed(system, held);
  ASSERT_TRUE(fixed.is_consistent());
  const std::vector<base::Matrix> load{force, on_other};
  const contact::ResponseWithoutContact free = contact::response_without_contact(system, load);
  const std::vector<base::Matrix> moved = contact::external_displacements(
      system, free, fixed.solve_response(free.opening, free.on_mode));
  EXPECT_NEAR(system.row_opening(2, {moved[0].col(0), moved[1].col(0)}), fixed.row_pivots({2})[0],
              1e-12);
}

} // namespace
} // namespace spricka::test_system
