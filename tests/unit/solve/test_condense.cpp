// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/dense_solve.hpp"
#include "base/parallel.hpp"
#include "solve/condense.hpp"
#include "solve/rate.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <map>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace spricka::solve::test_condense {
namespace {

using base::Matrix;
using base::SymmetricCsc;
using base::Vector;

std::size_t at(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

/// A square net of nodes [side, side] joined by springs along edges and both diagonals: elastic,
/// two freedoms a node, free to move as a rigid body unless `ground` holds the left side.
struct SpringNet {
  int side;
  double ground;
  std::vector<int> number; ///< [nodes] place of each node in the numbering

  SpringNet(int s, double g) : side(s), ground(g), number(at(s) * at(s)) {
    std::iota(number.begin(), number.end(), 0);
  }

  [[nodiscard]] std::int64_t rows() const { return 2LL * side * side; }
  [[nodiscard]] std::int64_t row(int x, int y, int c) const {
    return 2LL * number[at(y * side + x)] + c;
  }

  /// Numbers the nodes so that those with `last(x, y)` come last; returns how many rows those have.
  template <class Last> std::int64_t put_last(Last last) {
    int next = 0;
    std::int64_t count = 0;
    for (const bool pass : {false, true}) {
      for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
          if (last(x, y) == pass) {
            number[at(y * side + x)] = next++;
            count += pass ? 2 : 0;
          }
        }
      }
    }
    return count;
  }

  [[nodiscard]] SymmetricCsc matrix() const {
    std::map<std::pair<std::int64_t, std::int64_t>, double> entries; // (column, row)
    const auto add = [&](std::int64_t i, std::int64_t j, double v) {
      if (i >= j) {
        entries[{j, i}] += v;
      }
    };
    const auto spring = [&](int x0, int y0, int x1, int y1, double k) {
      const double length = std::hypot(x1 - x0, y1 - y0);
      const double d[2] = {(x1 - x0) / length, (y1 - y0) / length};
      for (int a = 0; a < 2; ++a) {
        for (int b = 0; b < 2; ++b) {
          const double v = k * d[a] * d[b];
          add(row(x0, y0, a), row(x0, y0, b), v);
          add(row(x1, y1, a), row(x1, y1, b), v);
          add(row(x0, y0, a), row(x1, y1, b), -v);
          add(row(x1, y1, a), row(x0, y0, b), -v);
        }
      }
    };
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const double k = 1.0 + 0.3 * std::sin(x + 2.0 * y);
        if (x + 1 < side) {
          spring(x, y, x + 1, y, k);
        }
        if (y + 1 < side) {
          spring(x, y, x, y + 1, k);
        }
        if (x + 1 < side && y + 1 < side) {
          spring(x, y, x + 1, y + 1, 0.5 * k);
          spring(x + 1, y, x, y + 1, 0.7 * k);
        }
      }
      if (ground > 0.0) {
        add(row(0, y, 0), row(0, y, 0), ground);
        add(row(0, y, 1), row(0, y, 1), ground);
      }
    }
    return compress(entries);
  }

  /// Displacements of the three rigid motions [rows, 3].
  [[nodiscard]] Matrix rigid() const {
    Matrix R = Matrix::Zero(rows(), 3);
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        R(row(x, y, 0), 0) = 1.0;
        R(row(x, y, 1), 1) = 1.0;
        R(row(x, y, 0), 2) = -static_cast<double>(y) / side;
        R(row(x, y, 1), 2) = static_cast<double>(x) / side;
      }
    }
    return R;
  }

private:
  [[nodiscard]] SymmetricCsc
  compress(const std::map<std::pair<std::int64_t, std::int64_t>, double>& entries) const {
    SymmetricCsc K;
    K.n = rows();
    K.start.assign(at(K.n) + 1, 0);
    for (const auto& [place, value] : entries) {
      K.row.push_back(place.second);
      K.value.push_back(value);
      ++K.start[at(place.first) + 1];
    }
    std::partial_sum(K.start.begin(), K.start.end(), K.start.begin());
    return K;
  }
};

Matrix dense(const SymmetricCsc& K) {
  Matrix A = Matrix::Zero(K.n, K.n);
  for (std::int64_t j = 0; j < K.n; ++j) {
    for (std::int64_t p = K.start[at(j)]; p < K.start[at(j) + 1]; ++p) {
      A(K.row[at(p)], j) = K.value[at(p)];
      A(j, K.row[at(p)]) = K.value[at(p)];
    }
  }
  return A;
}

Matrix random_columns(std::int64_t n, int k) {
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  return Matrix::NullaryExpr(n, k, [&] { return number(engine); });
}

Matrix dense_schur(const Matrix& A, std::int64_t l) {
  const std::int64_t e = A.rows() - l;
  return A.bottomRightCorner(e, e) -
         A.bottomLeftCorner(e, l) * base::solve_square_system(Matrix(A.topLeftCorner(l, l)),
                                                              Matrix(A.topRightCorner(l, e)));
}

bool same_bits(const Matrix& a, const Matrix& b) {
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0;
}

TEST(Condensation, SchurComplementIsThatOfDenseElimination) {
  for (const OrderingMethod ordering : {OrderingMethod::amd, OrderingMethod::metis}) {
    SpringNet net(14, 0.8);
    const std::int64_t e =
        net.put_last([](int x, int y) { return x == 13 || (x == 6 && y % 3 == 0); });
    const SymmetricCsc K = net.matrix();
    const Condensation c(K, e, {.ordering = ordering});
    ASSERT_EQ(c.report().status, FactorStatus::ok);
    const Matrix S = dense_schur(dense(K), K.n - e);
    EXPECT_LT((c.schur() - S).norm(), 1e-12 * S.norm());
    EXPECT_TRUE(same_bits(c.schur(), c.schur().transpose()));
    EXPECT_GT(c.report().flops, 0.0);
    EXPECT_GT(c.report().factor_entries, static_cast<double>(K.n));
    EXPECT_GT(c.report().memory, 8.0 * c.report().factor_entries);
  }
}

TEST(Condensation, ForecastIsWhatFactorisingReports) {
  for (const bool faces : {false, true}) {
    SpringNet net(24, 1.0);
    const std::int64_t externals = net.put_last([&](int x, int) { return faces && x == 23; });
    const Condensation c(net.matrix(), externals);
    SymmetricCsc pattern = net.matrix();
    std::fill(pattern.value.begin(), pattern.value.end(), 0.0);
    const FactorReport told = Condensation::forecast(std::move(pattern), externals);
    EXPECT_EQ(told.status, FactorStatus::ok);
    EXPECT_EQ(told.flops, c.report().flops);
    EXPECT_EQ(told.factor_entries, c.report().factor_entries);
    EXPECT_EQ(told.memory, c.report().memory);
  }
}

TEST(FlopRate, GrowsWithTheBlocks) {
  const FlopRate rate = measure_flop_rate(0.01);
  EXPECT_GT(rate.measured, 1e7);
  EXPECT_GE(rate.peak, rate.measured);
  EXPECT_LE(rate.at(8.0), rate.at(64.0));
  EXPECT_LE(rate.at(64.0), rate.peak);
}

TEST(Condensation, CondensedLoadAndRecoveredLocalsSolveTheWhole) {
  SpringNet net(12, 1.3);
  const std::int64_t e = net.put_last([](int x, int y) { return y == 11 && x > 2; });
  const SymmetricCsc K = net.matrix();
  const Matrix A = dense(K);
  const std::int64_t l = K.n - e;
  const Matrix f = random_columns(K.n, 5);
  const Condensation c(K, e);
  const Matrix f_e = c.condense_load(f);
  const Matrix expected =
      f.bottomRows(e) -
      A.bottomLeftCorner(e, l) *
          base::solve_square_system(Matrix(A.topLeftCorner(l, l)), Matrix(f.topRows(l)));
  EXPECT_LT((f_e - expected).norm(), 1e-12 * expected.norm());
  const Matrix u = c.recover(base::solve_square_system(Matrix(c.schur()), f_e), f);
  EXPECT_LT((A * u - f).norm(), 1e-12 * A.norm() * u.norm());
  const Matrix whole = base::solve_square_system(A, f);
  EXPECT_LT((u - whole).norm(), 1e-11 * whole.norm());
}

// Rows of two or three unknowns, of locals and of externals.
SparseRightHandSides random_rows(std::int64_t n, int k) {
  std::mt19937 engine(11);
  std::uniform_int_distribution<std::int64_t> place(0, n - 1);
  std::uniform_real_distribution<double> weight(-1.0, 1.0);
  SparseRightHandSides F;
  for (int j = 0; j < k; ++j) {
    for (int i = 0; i < 2 + j % 2; ++i) {
      F.row.push_back(place(engine));
      F.value.push_back(weight(engine));
    }
    F.start.push_back(static_cast<std::int64_t>(F.row.size()));
  }
  return F;
}

TEST(Condensation, CompliancesOfRowsAreThoseOfTheirHalfSolves) {
  for (const bool faces : {false, true}) {
    SpringNet net(20, faces ? 0.0 : 0.7);
    const std::int64_t e = net.put_last([&](int x, int y) { return faces && x == 19 && y < 9; });
    const SymmetricCsc K = net.matrix();
    const Matrix A = dense(K);
    const std::int64_t l = K.n - e;
    const Condensation c(K, e, {.ordering = OrderingMethod::metis});
    const SparseRightHandSides sparse = random_rows(K.n, 300); // more than one panel
    Matrix F = Matrix::Zero(K.n, 300);
    for (int j = 0; j < 300; ++j) {
      for (std::int64_t p = sparse.start[at(j)]; p < sparse.start[at(j + 1)]; ++p) {
        F(sparse.row[at(p)], j) += sparse.value[at(p)];
      }
    }
    const RowCompliance found = c.compliance_with_externals_held(sparse);
    const Matrix U = base::solve_square_system(Matrix(A.topLeftCorner(l, l)), Matrix(F.topRows(l)));
    const Matrix W = F.topRows(l).transpose() * U;
    EXPECT_LT((found.W - W).norm(), 1e-12 * W.norm());
    EXPECT_TRUE(same_bits(found.W, found.W.transpose()));
    const Matrix left = F.bottomRows(e) - A.bottomLeftCorner(e, l) * U;
    EXPECT_LE((found.condensed - left).norm(), 1e-12 * left.norm());
    EXPECT_TRUE(same_bits(found.W, c.compliance_with_externals_held(sparse).W));
    const FactorReport told =
        Condensation::forecast(K, e, {.ordering = OrderingMethod::metis}, &sparse);
    EXPECT_EQ(told.row_flops, found.flops);
    EXPECT_GT(told.row_memory, 0.0);
  }
}

TEST(Condensation, FloatingBodyNeedsNoSupport) {
  SpringNet net(15, 0.0);
  const std::int64_t e = net.put_last([](int x, int y) { return x == 0 || (y == 0 && x < 9); });
  const SymmetricCsc K = net.matrix();
  const Condensation c(K, e);
  ASSERT_EQ(c.report().status, FactorStatus::ok);
  const Matrix R = net.rigid().bottomRows(e);
  EXPECT_LT((c.schur() * R).cwiseAbs().maxCoeff(), 1e-12 * c.schur().cwiseAbs().maxCoeff());
  const Matrix u = c.recover(R, Matrix::Zero(K.n, 3)); // externals moved rigidly carry the rest
  EXPECT_LT((u - net.rigid()).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(Condensation, SingleExternalFreedomsMayBeSpread) {
  // normals only: one freedom of some nodes, and two whole nodes that carry the body
  SpringNet net(10, 0.0);
  SymmetricCsc K = net.matrix();
  const Matrix A = dense(K);
  std::vector<std::int64_t> order;
  std::vector<std::int64_t> last;
  for (std::int64_t i = 0; i < K.n; ++i) {
    const std::int64_t node = i / 2;
    const bool external = node == 0 || node == 99 || (i % 2 == 0 && node % 10 == 9);
    (external ? last : order).push_back(i);
  }
  const std::int64_t e = static_cast<std::int64_t>(last.size());
  order.insert(order.end(), last.begin(), last.end());
  Matrix P(K.n, K.n);
  SymmetricCsc Kp;
  Kp.n = K.n;
  Kp.start.push_back(0);
  for (std::int64_t j = 0; j < K.n; ++j) {
    for (std::int64_t i = 0; i < K.n; ++i) {
      P(i, j) = A(order[at(i)], order[at(j)]);
      if (i >= j && (i == j || P(i, j) != 0.0)) {
        Kp.row.push_back(i);
        Kp.value.push_back(P(i, j));
      }
    }
    Kp.start.push_back(static_cast<std::int64_t>(Kp.row.size()));
  }
  const Condensation c(Kp, e);
  const Matrix S = dense_schur(P, K.n - e);
  EXPECT_LT((c.schur() - S).norm(), 1e-12 * A.norm());
}

TEST(Condensation, RepeatsToTheLastBit) {
  SpringNet net(20, 0.5);
  const std::int64_t e = net.put_last([](int x, int) { return x == 19; });
  const SymmetricCsc K = net.matrix();
  const Matrix f = random_columns(K.n, 3);
  for (const OrderingMethod ordering : {OrderingMethod::amd, OrderingMethod::metis}) {
    const Condensation a(K, e, {.ordering = ordering});
    const Condensation b(K, e, {.ordering = ordering});
    EXPECT_TRUE(same_bits(a.schur(), b.schur()));
    EXPECT_TRUE(same_bits(a.recover(f.topRows(e), f), b.recover(f.topRows(e), f)));
  }
}

TEST(Condensation, SideBySideGivesTheSameBits) {
  std::vector<SymmetricCsc> K;
  std::vector<std::int64_t> externals;
  for (const int side : {18, 23, 30, 21}) {
    SpringNet net(side, 0.5);
    externals.push_back(net.put_last([side](int x, int) { return x == side - 1; }));
    K.push_back(net.matrix());
  }
  std::vector<Matrix> together(K.size());
  base::parallel_for(K.size(), 4, [&](std::size_t i) {
    together[i] = Condensation(K[i], externals[i], {.ordering = OrderingMethod::metis}).schur();
  });
  for (std::size_t i = 0; i < K.size(); ++i) {
    EXPECT_TRUE(
        same_bits(together[i],
                  Condensation(K[i], externals[i], {.ordering = OrderingMethod::metis}).schur()));
  }
}

TEST(Condensation, WithoutExternalsItSolves) {
  SpringNet net(13, 0.9);
  const SymmetricCsc K = net.matrix();
  const Condensation c(K, 0);
  const Matrix f = random_columns(K.n, 2);
  EXPECT_EQ(c.schur().size(), 0);
  const Matrix u = c.recover(Matrix(0, 2), f);
  EXPECT_LT((dense(K) * u - f).norm(), 1e-12 * dense(K).norm() * u.norm());
  EXPECT_EQ(c.condense_load(f).rows(), 0);
}

TEST(Condensation, WithExternalsOnlyItIsTheMatrix) {
  SpringNet net(6, 0.0);
  const SymmetricCsc K = net.matrix();
  const Condensation c(K, K.n);
  ASSERT_EQ(c.report().status, FactorStatus::ok);
  EXPECT_LT((c.schur() - dense(K)).norm(), 1e-13 * dense(K).norm());
  const Matrix f = random_columns(K.n, 2);
  EXPECT_TRUE(same_bits(c.condense_load(f), f));
  EXPECT_TRUE(same_bits(c.recover(f, f), f));
}

TEST(Condensation, NothingAtAllIsFine) {
  SymmetricCsc K;
  K.start.push_back(0);
  const Condensation c(K, 0);
  EXPECT_EQ(c.report().status, FactorStatus::ok);
  EXPECT_EQ(c.recover(Matrix(0, 1), Matrix(0, 1)).rows(), 0);
}

TEST(Condensation, NamesTheRowWithoutStiffness) {
  SpringNet net(9, 1.0);
  SymmetricCsc K = net.matrix();
  const std::int64_t loose = net.row(4, 7, 1);
  for (std::int64_t j = 0; j < K.n; ++j) {
    for (std::int64_t p = K.start[at(j)]; p < K.start[at(j) + 1]; ++p) {
      if (j == loose || K.row[at(p)] == loose) {
        K.value[at(p)] = 0.0;
      }
    }
  }
  const Condensation c(K, 0);
  EXPECT_EQ(c.report().status, FactorStatus::not_positive_definite);
  EXPECT_EQ(c.report().failed_row, loose);
}

TEST(Condensation, UnsupportedBodyIsNotSolvedSilently) {
  for (const int side : {3, 8, 21, 60}) {
    const SymmetricCsc K = SpringNet(side, 0.0).matrix();
    const Condensation c(K, 0);
    EXPECT_EQ(c.report().status, FactorStatus::not_positive_definite) << side;
    EXPECT_GE(c.report().failed_row, 0);
    EXPECT_LT(c.report().failed_row, K.n);
  }
  // a soft ground is enough
  const SymmetricCsc K = SpringNet(21, 1e-6).matrix();
  EXPECT_EQ(Condensation(K, 0).report().status, FactorStatus::ok);
}

TEST(Condensation, NumbersThatAreNoneAreRefused) {
  SymmetricCsc K = SpringNet(5, 1.0).matrix();
  K.value[at(K.start[7])] = std::nan("");
  EXPECT_EQ(Condensation(K, 4).report().status, FactorStatus::not_positive_definite);
}

TEST(Condensation, MovesWithItsFactor) {
  SpringNet net(7, 1.0);
  const SymmetricCsc K = net.matrix();
  Condensation first(K, 4);
  const Matrix f = random_columns(K.n, 1);
  const Matrix u = first.recover(f.topRows(4), f);
  Condensation second(std::move(first));
  EXPECT_TRUE(same_bits(second.recover(f.topRows(4), f), u));
  second = Condensation(K, 4);
  EXPECT_TRUE(same_bits(second.recover(f.topRows(4), f), u));
}

} // namespace
} // namespace spricka::solve::test_condense
