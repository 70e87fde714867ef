// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/condense.hpp"
#include "solve/factor_law.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace spricka::test_factor_law {
namespace {

using solve::FactorReport;
using solve::NetOutline;

// Nodes of a grid of bilinear or trilinear elements, `dim` unknowns each; the layer x = nx is
// external or held.
struct Grid {
  int dim, nx, ny, nz;
  bool external;
};

base::SymmetricCsc pattern_of(const Grid& grid) {
  const int nz = grid.dim == 3 ? grid.nz : 0;
  std::vector<std::array<int, 3>> place;
  for (int i = 0; i < grid.nx + (grid.external ? 1 : 0); ++i) {
    for (int j = 0; j <= grid.ny; ++j) {
      for (int k = 0; k <= nz; ++k) {
        place.push_back({i, j, k}); // the layer of externals last
      }
    }
  }
  const auto at = [&](int i, int j, int k) { return (i * (grid.ny + 1) + j) * (nz + 1) + k; };
  const int layers = grid.nx + (grid.external ? 1 : 0);
  base::SymmetricCsc K;
  K.start.push_back(0);
  for (const auto& [i, j, k] : place) {
    std::vector<int> beside;
    for (int a = std::max(0, i - 1); a <= std::min(layers - 1, i + 1); ++a) {
      for (int b = std::max(0, j - 1); b <= std::min(grid.ny, j + 1); ++b) {
        for (int c = std::max(0, k - 1); c <= std::min(nz, k + 1); ++c) {
          beside.push_back(at(a, b, c));
        }
      }
    }
    for (int c = 0; c < grid.dim; ++c) {
      const std::int64_t column = std::int64_t{grid.dim} * at(i, j, k) + c;
      for (const int node : beside) {
        for (int d = 0; d < grid.dim; ++d) {
          if (const std::int64_t row = std::int64_t{grid.dim} * node + d; row >= column) {
            K.row.push_back(row);
          }
        }
      }
      K.start.push_back(static_cast<std::int64_t>(K.row.size()));
    }
  }
  K.n = static_cast<std::int64_t>(K.start.size()) - 1;
  K.value.assign(K.row.size(), 0.0);
  return K;
}

void compare(const Grid& grid) {
  base::SymmetricCsc K = pattern_of(grid);
  NetOutline outline;
  outline.dim = grid.dim;
  outline.cells = {static_cast<double>(grid.nx), static_cast<double>(grid.ny),
                   grid.dim == 3 ? grid.nz : 1.0};
  const int layer = grid.dim * (grid.ny + 1) * (grid.dim == 3 ? grid.nz + 1 : 1);
  const std::int64_t externals = grid.external ? layer : 0;
  outline.externals = static_cast<double>(externals);
  outline.locals = static_cast<double>(K.n - externals);
  outline.row_neighbours = grid.dim == 3 ? 27.0 : 9.0;
  const FactorReport law = solve::estimate_factor(outline);
  const FactorReport exact = solve::Condensation::forecast(std::move(K), externals);
  const auto near = [&](double a, double b, double factor, const char* what) {
    EXPECT_LT(std::abs(std::log(a / b)), std::log(factor))
        << what << " of " << grid.nx << " x " << grid.ny << " x " << grid.nz << ": " << a
        << " by the law, " << b;
  };
  near(law.factor_entries, exact.factor_entries, 1.4, "entries");
  near(law.flops, exact.flops, 2.0, "flops");
  near(law.memory, exact.memory, 1.4, "memory");
}

// Cubes, a slab, a bar, a face of externals: the power of n differs, the law holds.
TEST(FactorLaw, FollowsTheShapeInSpace) {
  compare({3, 7, 7, 7, false});
  compare({3, 14, 14, 14, false});
  compare({3, 40, 30, 2, false});
  compare({3, 200, 4, 4, false});
  compare({3, 12, 12, 12, true});
}

TEST(FactorLaw, FollowsTheShapeInThePlane) {
  compare({2, 20, 20, 0, false});
  compare({2, 100, 100, 0, false});
  compare({2, 300, 12, 0, false});
  compare({2, 80, 80, 0, true});
}

TEST(FactorLaw, NothingCostsNothing) {
  EXPECT_EQ(solve::estimate_factor({}).flops, 0.0);
  NetOutline dense; // externals alone: one dense matrix
  dense.externals = 300.0;
  EXPECT_NEAR(solve::estimate_factor(dense).flops, 9e6, 1.0);
}

// Rows of contact on a face of a cube, once and twice as many.
TEST(FactorLaw, RowsCostBesidesTheFactor) {
  NetOutline cube{.dim = 3, .cells = {10.0, 10.0, 10.0}, .locals = 3993.0, .row_neighbours = 27.0};
  const FactorReport without = solve::estimate_factor(cube);
  cube.rows = 100.0;
  const FactorReport some = solve::estimate_factor(cube);
  cube.rows = 200.0;
  const FactorReport more = solve::estimate_factor(cube);
  EXPECT_EQ(without.row_flops, 0.0);
  EXPECT_NEAR(without.flops, some.flops, 1e-9 * some.flops);
  EXPECT_GT(more.row_flops, 2.0 * some.row_flops);
  EXPECT_LT(more.row_flops, 4.0 * some.row_flops);
}

} // namespace
} // namespace spricka::test_factor_law
