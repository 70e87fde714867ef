// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/outer_products.hpp"

#include <gtest/gtest.h>

namespace spricka::base {
namespace {

// Rows that fill wide registers, and any rest of them; any number of columns of A.
TEST(OuterProducts, AreThoseOfEachEntry) {
  const double factor = 0.3;
  for (Eigen::Index k = 1; k <= 4; ++k) {
    for (Eigen::Index m = 1; m <= 19; ++m) {
      const Matrix A = Matrix::Random(m, k);
      const Matrix B = Matrix::Random(5, k);
      const Matrix before = Matrix::Random(m, 5);
      Matrix C = before;
      add_outer_products(factor, A, B, C);
      for (Eigen::Index i = 0; i < m; ++i) {
        for (Eigen::Index j = 0; j < 5; ++j) {
          double sum = A(i, 0) * B(j, 0);
          for (Eigen::Index c = 1; c < k; ++c) {
            sum += A(i, c) * B(j, c);
          }
          EXPECT_EQ(C(i, j), before(i, j) + factor * sum) << m << " rows, " << k << " columns";
        }
      }
    }
  }
}

TEST(OuterProducts, StayWithinPartsOfMatrices) {
  Matrix C = Matrix::Zero(9, 6);
  const Matrix A = Matrix::Ones(12, 3);
  const Matrix B = Matrix::Ones(8, 4);
  add_outer_products(2.0, A.block(1, 0, 7, 3), B.block(2, 1, 4, 3), C.block(1, 1, 7, 4));
  Matrix expected = Matrix::Zero(9, 6);
  expected.block(1, 1, 7, 4).setConstant(6.0);
  EXPECT_EQ(C, expected);
}

} // namespace
} // namespace spricka::base
