// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/dense_solve.hpp"
#include "base/index.hpp"
#include "solve/substructured_factor.hpp"

#include <array>
#include <cstdint>
#include <gtest/gtest.h>
#include <map>
#include <memory>
#include <utility>
#include <vector>

// A body by the factors of a part and of the region that the part stands in, against the dense
// matrix of the whole.
namespace spricka::solve::test_substructured_factor {
namespace {

using base::at;
using base::index;
using base::Matrix;

constexpr int side = 12;
constexpr int rim = 7; ///< the column of nodes that part and region share

/// Unknowns of a square grid of nodes, each of them one: a part left of the rim, and all others.
struct GridNumbers {
  std::vector<std::int64_t> whole; ///< [node] locals of the part first, then the region
  std::int64_t part_locals = rim * side;
  std::int64_t externals = 0; ///< the last of the region
};

GridNumbers number_grid(std::int64_t externals) {
  GridNumbers numbers;
  for (int n = 0; n < side * side; ++n) { // column by column: the part is the first ones
    numbers.whole.push_back(n);
  }
  numbers.externals = externals;
  return numbers;
}

/// Springs between neighbours and to the ground in the columns [begin, end] of nodes; those in the
/// column `without` are another's. Unknowns by `place`.
base::SymmetricCsc springs(int begin, int end, int without, const std::vector<std::int64_t>& place,
                           std::int64_t size) {
  std::vector<std::map<std::int64_t, double>> column(at(size));
  const auto add = [&](std::int64_t i, std::int64_t j, double value) {
    column[at(std::min(i, j))][std::max(i, j)] += value;
  };
  for (std::int64_t i = 0; i < size; ++i) {
    column[at(i)][i] = 0.0;
  }
  const auto node = [](int x, int y) { return at(x * side + y); };
  const auto link = [&](std::size_t a, std::size_t b, double stiffness) {
    add(place[a], place[a], stiffness);
    add(place[b], place[b], stiffness);
    add(place[a], place[b], -stiffness);
  };
  for (int x = begin; x <= end; ++x) {
    for (int y = 0; y < side; ++y) {
      if (x != without) {
        add(place[node(x, y)], place[node(x, y)], 0.02 * (1 + x));
      }
      if (y + 1 < side && x != without) {
        link(node(x, y), node(x, y + 1), 1.0 + 0.1 * y);
      }
      if (x < end) {
        link(node(x, y), node(x + 1, y), 2.0 - 0.1 * x);
      }
    }
  }
  base::SymmetricCsc K{size, {0}, {}, {}};
  for (const auto& entries : column) {
    for (const auto& [row, value] : entries) {
      K.row.push_back(row);
      K.value.push_back(value);
    }
    K.start.push_back(index(K.row.size()));
  }
  return K;
}

Matrix dense(const base::SymmetricCsc& K) {
  Matrix A = Matrix::Zero(K.n, K.n);
  for (std::int64_t j = 0; j < K.n; ++j) {
    for (std::int64_t p = K.start[at(j)]; p < K.start[at(j + 1)]; ++p) {
      A(K.row[at(p)], j) = A(j, K.row[at(p)]) = K.value[at(p)];
    }
  }
  return A;
}

/// The grid in two factors; `stacked`: the part's Schur complement stays out of the sparse matrix.
SubstructuredFactor factorise(const GridNumbers& numbers, bool stacked) {
  const std::int64_t n = side * side;
  FactorisedPart part;
  part.locals = numbers.part_locals;
  const auto own = std::make_shared<Condensation>(
      springs(0, rim, side, numbers.whole, part.locals + side), side);
  part.factor = own;
  std::vector<std::int64_t> in_region;
  for (const std::int64_t unknown : numbers.whole) {
    in_region.push_back(unknown - part.locals);
  }
  for (std::int64_t k = 0; k < side; ++k) {
    part.rows.push_back(k); // the rim comes first in the region
  }
  base::SymmetricCsc K = springs(rim, side - 1, rim, in_region, n - part.locals);
  std::shared_ptr<Condensation> region;
  if (stacked) {
    const std::vector<CondensedNetBlock> blocks{{part.rows, &own->schur()}};
    region = std::make_shared<Condensation>(K, numbers.externals, blocks);
  } else {
    Matrix sum = dense(K);
    sum.topLeftCorner(side, side) += own->schur();
    base::SymmetricCsc filled{sum.rows(), {0}, {}, {}};
    for (Eigen::Index j = 0; j < sum.cols(); ++j) {
      for (Eigen::Index i = j; i < sum.rows(); ++i) {
        filled.row.push_back(i);
        filled.value.push_back(sum(i, j));
      }
      filled.start.push_back(index(filled.row.size()));
    }
    region = std::make_shared<Condensation>(std::move(filled), numbers.externals);
  }
  return {{std::move(part)}, region, n - numbers.part_locals};
}

/// Columns on the part alone, then some on the region and some on both.
SparseRightHandSides columns(std::int64_t on_part, std::int64_t others) {
  SparseRightHandSides F;
  for (std::int64_t k = 0; k < on_part + others; ++k) {
    const bool part = k < on_part;
    for (const std::int64_t row : {(7 * k) % (part ? 80 : 140), (13 * k + 5) % (part ? 80 : 140)}) {
      F.row.push_back(row);
      F.value.push_back(1.0 + 0.01 * static_cast<double>(k));
    }
    F.start.push_back(index(F.row.size()));
  }
  return F;
}

Matrix dense(const SparseRightHandSides& F) {
  Matrix out = Matrix::Zero(side * side, F.count());
  for (std::int64_t k = 0; k < F.count(); ++k) {
    for (std::int64_t p = F.start[at(k)]; p < F.start[at(k + 1)]; ++p) {
      out(F.row[at(p)], k) += F.value[at(p)];
    }
  }
  return out;
}

struct Case {
  std::int64_t externals;
  bool stacked;
};
constexpr std::array<Case, 4> cases{{{0, false}, {0, true}, {5, false}, {5, true}}};

TEST(SubstructuredFactor, SolvesAsTheMatrixOfTheWhole) {
  for (const auto& [externals, stacked] : cases) {
    const GridNumbers numbers = number_grid(externals);
    const Matrix A = dense(springs(0, side - 1, side, numbers.whole, side * side));
    const SubstructuredFactor factor = factorise(numbers, stacked);
    ASSERT_EQ(factor.size(), A.rows());
    const Matrix f = dense(columns(3, 4));
    const std::int64_t l = A.rows() - externals;
    const Matrix held = Matrix::Constant(externals, f.cols(), 0.3);
    Matrix condensed;
    const Matrix u = factor.solve(f, [&](const Matrix& load) {
      condensed = load;
      return held;
    });
    const Matrix locals =
        base::solve_square_system(Matrix(A.topLeftCorner(l, l)),
                                  Matrix(f.topRows(l) - A.topRightCorner(l, externals) * held));
    EXPECT_LT((u.topRows(l) - locals).norm(), 1e-12 * locals.norm());
    EXPECT_EQ(u.bottomRows(externals), held);
    if (externals > 0) {
      const Matrix free =
          base::solve_square_system(Matrix(A.topLeftCorner(l, l)), Matrix(f.topRows(l)));
      const Matrix left = f.bottomRows(externals) - A.bottomLeftCorner(externals, l) * free;
      EXPECT_LT((condensed - left).norm(), 1e-12 * left.norm());
    }
  }
}

TEST(SubstructuredFactor, CompliancesAreThoseOfTheWholeWhateverIsKept) {
  for (const auto& [externals, stacked] : cases) {
    const GridNumbers numbers = number_grid(externals);
    const Matrix A = dense(springs(0, side - 1, side, numbers.whole, side * side));
    const std::int64_t l = A.rows() - externals;
    const SubstructuredFactor factor = factorise(numbers, stacked);
    const SparseRightHandSides sparse = columns(20, 30);
    const Matrix F = dense(sparse);
    const Matrix U = base::solve_square_system(Matrix(A.topLeftCorner(l, l)), Matrix(F.topRows(l)));
    const Matrix W = F.topRows(l).transpose() * U;
    const Matrix left = F.bottomRows(externals) - A.bottomLeftCorner(externals, l) * U;
    const RowCompliance plain = factor.compliance_with_externals_held(sparse);
    EXPECT_LT((plain.W - W).norm(), 1e-12 * W.norm());
    EXPECT_LE((plain.condensed - left).norm(), 1e-12 * left.norm());

    LastingColumns kept;
    const RowCompliance first = factor.compliance_with_externals_held(sparse, 20, &kept);
    EXPECT_LT((first.W - W).norm(), 1e-12 * W.norm());
    EXPECT_EQ(first.W, Matrix(first.W.transpose()));
    ASSERT_EQ(kept.F.count(), 20);
    const RowCompliance again = factor.compliance_with_externals_held(sparse, 20, &kept);
    EXPECT_EQ(again.W, first.W); // to the last bit
    EXPECT_EQ(again.condensed, first.condensed);
    EXPECT_LT(again.flops, first.flops);
    // Other columns than those kept are made anew.
    SparseRightHandSides others = sparse;
    others.value.front() *= 2.0;
    const RowCompliance changed = factor.compliance_with_externals_held(others, 20, &kept);
    EXPECT_NEAR(changed.W(1, 0),
                first.W(1, 0) + F(others.row.front(), 0) * U(others.row.front(), 1),
                1e-12 * W.norm());
  }
}

} // namespace
} // namespace spricka::solve::test_substructured_factor
