// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/panel_elimination.hpp"
#include "base/index.hpp"
#include "solve/blas.hpp"

#include <algorithm>

namespace spricka::solve {

using base::at;

namespace {

// Up to so many columns a block on the diagonal is multiplied with what is below it at once: half
// of it in vain, but by one call.
constexpr int one_product = 32;
} // namespace

// The entries of A in some rows of a panel, the others zero.
void PanelElimination::begin_tile(const PanelTile& tile) const {
  const FactorPanel& p = cut_.panels()[at(tile.panel)];
  const std::int64_t first = p.row[tile.begin];
  const std::int64_t last = p.row[tile.end - 1];
  for (int j = 0; j < p.columns; ++j) {
    double* const column = values_ + p.value + static_cast<std::ptrdiff_t>(j) * p.stride;
    std::fill(column + tile.begin, column + tile.end, 0.0);
    for (std::int64_t k = A_.start[at(p.first + j)]; k < A_.start[at(p.first + j) + 1]; ++k) {
      const std::int64_t row = A_.row[at(k)];
      if (row >= first && row <= last) {
        const std::int64_t* const at_row =
            std::lower_bound(p.row + tile.begin, p.row + tile.end, row);
        column[at_row - p.row] += A_.value[at(k)];
      }
    }
  }
}

void PanelElimination::set_places(const PanelTile& tile, PanelWorkspace& work) const {
  const FactorPanel& p = cut_.panels()[at(tile.panel)];
  for (int i = tile.begin; i < tile.end; ++i) {
    work.place[at(p.row[i])] = i;
  }
}

void PanelElimination::take_off(const PanelTile& tile, std::span<const PanelUpdate> updates,
                                PanelWorkspace& work) const {
  const FactorPanel& p = cut_.panels()[at(tile.panel)];
  const bool whole = tile.begin == 0 && tile.end == p.rows;
  set_places(tile, work);
  for (const PanelUpdate& u : updates) {
    const FactorPanel& from = cut_.panels()[at(u.panel)];
    int lo = u.begin;
    int hi = from.rows;
    if (!whole) {
      const std::int64_t* const end = from.row + from.rows;
      const std::int64_t* const begin =
          tile.has_diagonal() ? from.row + u.begin
                              : std::lower_bound(from.row + u.end, end, p.row[tile.begin]);
      lo = static_cast<int>(begin - from.row);
      hi = static_cast<int>(std::upper_bound(begin, end, p.row[tile.end - 1]) - from.row);
    }
    if (lo < hi) {
      subtract_product(p, from, u, lo, hi, work);
    }
  }
}

// Rows [lo, hi) of an earlier panel times those that are columns of p; where the former begin with
// the latter, a block on the diagonal.
void PanelElimination::subtract_product(const FactorPanel& p, const FactorPanel& from,
                                        const PanelUpdate& u, int lo, int hi,
                                        PanelWorkspace& work) const {
  const int m = hi - lo;
  const int n = u.end - u.begin;
  const int k = from.columns;
  const double* const A = values_ + from.value;
  const bool diagonal = lo == u.begin;
  const bool parted = diagonal && n > one_product;
  if (p.supernode == from.supernode) {
    // Its rows are those of p, one after the other.
    double* const C = values_ + p.value + work.place[at(from.row[lo])];
    const int top = parted ? n : 0;
    if (parted) {
      blas::row_gram(n, k, -1.0, 1.0, {A + lo, from.stride}, {C, p.stride});
    }
    blas::gemm({.m = m - top,
                .n = n,
                .k = k,
                .b = blas::Transposition::transposed,
                .alpha = -1.0,
                .beta = 1.0},
               {A + lo + top, from.stride}, {A + u.begin, from.stride}, {C + top, p.stride});
    return;
  }
  base::Matrix& C = work.product;
  if (C.size() < static_cast<Eigen::Index>(m) * n) {
    C.resize(m, n);
  }
  const int top = parted ? n : 0;
  if (parted) {
    blas::row_gram(n, k, 1.0, 0.0, {A + lo, from.stride}, {C.data(), m});
  }
  blas::gemm({.m = m - top, .n = n, .k = k, .b = blas::Transposition::transposed},
             {A + lo + top, from.stride}, {A + u.begin, from.stride}, {C.data() + top, m});
  for (int j = 0; j < n; ++j) {
    const double* const product = C.data() + static_cast<std::ptrdiff_t>(j) * m;
    double* const column =
        values_ + p.value +
        (from.row[u.begin + j] - p.first) * static_cast<std::ptrdiff_t>(p.stride);
    for (int i = diagonal ? j : 0; i < m; ++i) {
      column[work.place[at(from.row[lo + i])]] -= product[i];
    }
  }
}

std::int64_t PanelElimination::factorise_diagonal(const FactorPanel& p) const {
  return p.first + blas::cholesky_until(p.columns, {values_ + p.value, p.stride});
}

void PanelElimination::eliminate_below(const FactorPanel& p, int begin, int end) const {
  blas::solve_lower_from_right(end - begin, p.columns, {values_ + p.value, p.stride},
                               {values_ + p.value + begin, p.stride});
}

} // namespace spricka::solve
