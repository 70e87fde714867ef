// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/factor_substitution.hpp"
#include "base/index.hpp"
#include "base/parallel.hpp"
#include "solve/blas.hpp"

#include <algorithm>
#include <memory>

namespace spricka::solve {

using base::at;
using base::index;

namespace {

// Rows that are taken at a time.
constexpr int row_run = 512;
// Entries of the factor below which a second thread would come too late.
constexpr double least_threaded_entries = 3e5;
// Subtrees whose effects on the panels above are held at a time.
constexpr std::size_t subtrees_at_once = 32;

blas::ConstMatrixBlock block(const FactorPanel& p, const double* values, int row) {
  return {values + p.value + row, p.stride};
}

} // namespace

FactorSubstitution::FactorSubstitution(const FactorPanels& cut, const double* values, int threads)
    : cut_(cut), values_(values), threads_(threads) {
  for (std::size_t i = 0; i < cut.pieces().size(); ++i) {
    if (cut.pieces()[i].is_subtree()) {
      subtrees_.push_back(i);
    }
  }
}

template <class Use>
void FactorSubstitution::for_row_runs(const FactorPanel& p, Eigen::Index columns,
                                      const Use& use) const {
  const int runs = (p.rows - p.columns + row_run - 1) / row_run;
  const double work = static_cast<double>(p.rows) * p.columns * static_cast<double>(columns);
  base::parallel_for(at(runs), work < least_threaded_entries ? 1 : threads_, [&](std::size_t i) {
    const int begin = p.columns + static_cast<int>(i) * row_run;
    use(i, begin, std::min(p.rows, begin + row_run));
  });
}

void FactorSubstitution::forward(base::Matrix& X) const {
  forward_subtrees(X);
  for (const FactorPanels::Piece& piece : cut_.pieces()) {
    const FactorPanel& p = cut_.panels()[at(piece.first)];
    if (!piece.is_subtree() && !p.external) {
      forward_panel(p, X);
    }
  }
}

void FactorSubstitution::forward_subtrees(base::Matrix& X) const {
  std::vector<base::Matrix> beyond(std::min(subtrees_at_once, subtrees_.size()));
  for (std::size_t first = 0; first < subtrees_.size(); first += subtrees_at_once) {
    const std::size_t count = std::min(subtrees_at_once, subtrees_.size() - first);
    base::parallel_for(count, threads_, [&](std::size_t i) {
      forward_subtree(cut_.pieces()[subtrees_[first + i]], X, beyond[i]);
    });
    for (std::size_t i = 0; i < count; ++i) {
      const FactorPanel& root = cut_.panels()[at(cut_.pieces()[subtrees_[first + i]].last)];
      for (Eigen::Index j = 0; j < X.cols() && beyond[i].size() > 0; ++j) {
        for (int r = root.columns; r < root.rows; ++r) {
          X(root.row[r], j) -= beyond[i](r - root.columns, j);
        }
      }
    }
  }
}

// What the panels above feel is gathered in `beyond` [rows below the last panel, k], which are all
// rows below the subtree (Liu 1990: the rows of a column are among those of its parent). Empty:
// nothing loads the subtree.
void FactorSubstitution::forward_subtree(const FactorPanels::Piece& piece, base::Matrix& X,
                                         base::Matrix& beyond) const {
  const FactorPanel& root = cut_.panels()[at(piece.last)];
  const std::int64_t begin = cut_.panels()[at(piece.first)].first;
  const std::int64_t end = root.first + root.columns;
  if (X.middleRows(begin, end - begin).isZero(0.0)) {
    beyond.resize(0, 0); // loads are sparse
    return;
  }
  const auto k = static_cast<int>(X.cols());
  beyond.setZero(root.rows - root.columns, k);
  // Of the rows beyond alone: nothing else is looked at.
  const auto place = std::make_unique_for_overwrite<std::int32_t[]>(at(X.rows())); // NOLINT
  for (int r = root.columns; r < root.rows; ++r) {
    place[at(root.row[r])] = r - root.columns;
  }
  base::Matrix update;
  for (std::int32_t i = piece.first; i <= piece.last; ++i) {
    const FactorPanel& p = cut_.panels()[at(i)];
    if (X.middleRows(p.first, p.columns).isZero(0.0)) {
      continue;
    }
    const blas::MatrixBlock x{X.data() + p.first, static_cast<int>(X.rows())};
    blas::solve_lower(p.columns, k, blas::Transposition::plain, block(p, values_, 0), x);
    const int below = p.rows - p.columns;
    if (below == 0) {
      continue;
    }
    update.resize(below, k);
    blas::gemm({.m = below, .n = k, .k = p.columns}, block(p, values_, p.columns), x,
               {update.data(), below});
    const std::int64_t* const row = p.row + p.columns;
    const auto within = static_cast<int>(std::lower_bound(row, row + below, end) - row);
    for (int j = 0; j < k; ++j) {
      for (int r = 0; r < within; ++r) {
        X(row[r], j) -= update(r, j);
      }
      for (int r = within; r < below; ++r) {
        beyond(place[at(row[r])], j) += update(r, j);
      }
    }
  }
}

void FactorSubstitution::forward_panel(const FactorPanel& p, base::Matrix& X) const {
  if (X.middleRows(p.first, p.columns).isZero(0.0)) {
    return;
  }
  const auto k = static_cast<int>(X.cols());
  const blas::MatrixBlock x{X.data() + p.first, static_cast<int>(X.rows())};
  blas::solve_lower(p.columns, k, blas::Transposition::plain, block(p, values_, 0), x);
  for_row_runs(p, k, [&](std::size_t, int begin, int end) {
    base::Matrix update(end - begin, k);
    blas::gemm({.m = end - begin, .n = k, .k = p.columns}, block(p, values_, begin), x,
               {update.data(), end - begin});
    for (int j = 0; j < k; ++j) {
      for (int r = begin; r < end; ++r) {
        X(p.row[r], j) -= update(r - begin, j);
      }
    }
  });
}

void FactorSubstitution::backward(base::Matrix& X) const {
  for (std::size_t i = cut_.pieces().size(); i-- > 0;) {
    const FactorPanels::Piece& piece = cut_.pieces()[i];
    const FactorPanel& p = cut_.panels()[at(piece.first)];
    if (!piece.is_subtree() && !p.external) {
      backward_panel(p, X);
    }
  }
  base::parallel_for(subtrees_.size(), threads_, [&](std::size_t i) {
    const FactorPanels::Piece& piece = cut_.pieces()[subtrees_[i]];
    base::Matrix known;
    for (std::int32_t panel = piece.last; panel >= piece.first; --panel) {
      const FactorPanel& p = cut_.panels()[at(panel)];
      subtract_known(p, p.columns, p.rows, known, X,
                     {X.data() + p.first, static_cast<int>(X.rows())}, 1.0);
      solve_transposed(p, X);
    }
  });
}

// C [columns of p, k] <- beta C - L^T X for rows [begin, end) of p; known: workspace.
void FactorSubstitution::subtract_known(const FactorPanel& p, int begin, int end,
                                        base::Matrix& known, const base::Matrix& X,
                                        blas::MatrixBlock C, double beta) const {
  const auto k = static_cast<int>(X.cols());
  known.resize(end - begin, k);
  for (int j = 0; j < k; ++j) {
    for (int r = begin; r < end; ++r) {
      known(r - begin, j) = X(p.row[r], j);
    }
  }
  blas::gemm({.m = p.columns,
              .n = k,
              .k = end - begin,
              .a = blas::Transposition::transposed,
              .alpha = -1.0,
              .beta = beta},
             block(p, values_, begin), {known.data(), end - begin}, C);
}

void FactorSubstitution::solve_transposed(const FactorPanel& p, base::Matrix& X) const {
  blas::solve_lower(p.columns, static_cast<int>(X.cols()), blas::Transposition::transposed,
                    block(p, values_, 0), {X.data() + p.first, static_cast<int>(X.rows())});
}

void FactorSubstitution::backward_panel(const FactorPanel& p, base::Matrix& X) const {
  std::vector<base::Matrix> part(at((p.rows - p.columns + row_run - 1) / row_run));
  for_row_runs(p, X.cols(), [&](std::size_t i, int begin, int end) {
    base::Matrix known;
    part[i].resize(p.columns, X.cols());
    subtract_known(p, begin, end, known, X, blas::as_matrix_block(part[i]), 0.0);
  });
  for (const base::Matrix& own : part) {
    X.middleRows(p.first, p.columns) += own;
  }
  solve_transposed(p, X);
}

} // namespace spricka::solve
