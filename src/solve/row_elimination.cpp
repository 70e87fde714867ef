// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/row_elimination.hpp"
#include "base/index.hpp"
#include "base/parallel.hpp"
#include "solve/blas.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace spricka::solve {

using base::at;
using base::index;

namespace {

constexpr int panel = 256; ///< columns that are multiplied at a time

/// Size of a front: columns of locals, and rows below them.
struct SupernodeSize {
  int columns = 0;
  int below = 0;
};

SupernodeSize shape_of(const SupernodalFactor& L, std::int64_t s) {
  const std::int64_t end = std::min(L.column[s + 1], L.locals);
  const auto columns = static_cast<int>(end - L.column[s]);
  const auto rows = static_cast<int>(L.row_start[s + 1] - L.row_start[s]);
  return {columns, rows - columns};
}

/// Rows below the columns of a front, ascending.
const std::int64_t* below_of(const SupernodalFactor& L, std::int64_t s) {
  return L.row + L.row_start[s] + shape_of(L, s).columns;
}

/// Calls use(front, first, end) for each run of the rows below front s that one front has, with the
/// places of the run among these rows; -1: of externals.
template <class Use>
void for_fronts_above(const SupernodalFactor& L, const std::vector<std::int64_t>& front_of,
                      std::int64_t s, Use&& use) {
  const std::int64_t* row = below_of(L, s);
  const int below = shape_of(L, s).below;
  const auto owner = [&](int i) { return row[i] < L.locals ? front_of[at(row[i])] : -1; };
  for (int first = 0; first < below;) {
    const std::int64_t above = owner(first);
    int end = first + 1;
    while (end < below && owner(end) == above) {
      ++end;
    }
    use(above, first, end);
    first = end;
  }
}

/// Places of some columns among those of a front above, which has them all.
void find_places(const std::vector<int>& columns, const std::vector<int>& above,
                 std::vector<int>& place) {
  place.resize(columns.size());
  if (columns.size() == above.size()) {
    for (std::size_t i = 0; i < place.size(); ++i) {
      place[i] = static_cast<int>(i);
    }
    return;
  }
  auto from = above.begin();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    from = std::lower_bound(from, above.end(), columns[i]);
    place[i] = static_cast<int>(from - above.begin());
  }
}

/// Calls use(first, width) for each panel of k columns, on several threads where each has `flops`
/// to do that are worth one.
template <class Use> void for_column_panels(int k, double flops, int threads, const Use& use) {
  constexpr double least_threaded_flops = 2e7;
  const auto count = static_cast<std::size_t>((k + panel - 1) / panel);
  base::parallel_for(count, flops < least_threaded_flops ? 1 : threads, [&](std::size_t i) {
    const int first = static_cast<int>(i) * panel;
    use(first, std::min(panel, k - first));
  });
}

/// Lower triangle of W, rows and columns `columns`, += X^T X; columns [first, first + width) of X.
void add_gram(const base::Matrix& X, const std::vector<int>& columns, int first, int width,
              base::Matrix& W) {
  const auto k = static_cast<int>(columns.size());
  const auto rows = static_cast<int>(X.rows());
  const auto n = static_cast<int>(W.rows());
  const blas::ConstMatrixBlock from{X.data() + static_cast<std::ptrdiff_t>(first) * rows, rows};
  if (k == n) { // all columns: nothing to scatter
    double* const into = W.data() + static_cast<std::ptrdiff_t>(first) * n + first;
    blas::gemm(
        {.m = k - first, .n = width, .k = rows, .a = blas::Transposition::transposed, .beta = 1.0},
        from, from, {into, n});
    return;
  }
  base::Matrix part(k - first, width);
  blas::gemm({.m = k - first, .n = width, .k = rows, .a = blas::Transposition::transposed}, from,
             from, {part.data(), k - first});
  for (int j = 0; j < width; ++j) {
    double* const into = W.data() + static_cast<std::ptrdiff_t>(columns[at(first + j)]) * n;
    for (int i = j; i < k - first; ++i) {
      into[columns[at(first + i)]] += part(i, j);
    }
  }
}

} // namespace

RowElimination::RowElimination(const SupernodalFactor& L, const SparseRightHandSides& F)
    : L_(L), fronts_(std::lower_bound(L.column, L.column + L.count, L.locals) - L.column),
      front_of_(at(L.locals)), own_(at(fronts_)), columns_(at(fronts_)), block_(at(fronts_)) {
  for (std::int64_t s = 0; s < fronts_; ++s) {
    for (std::int64_t j = L.column[s]; j < std::min(L.column[s + 1], L.locals); ++j) {
      front_of_[at(j)] = s;
    }
  }
  reach_up(F);
  count_cost();
}

void RowElimination::reach_up(const SparseRightHandSides& F) {
  for (std::int64_t k = 0; k < F.count(); ++k) {
    for (std::int64_t p = F.start[at(k)]; p < F.start[at(k + 1)]; ++p) {
      if (const std::int64_t row = F.row[at(p)]; row < L_.locals) {
        const std::int64_t s = front_of_[at(row)];
        own_[at(s)].push_back({static_cast<int>(k), static_cast<int>(row - L_.column[s]),
                               F.value.empty() ? 0.0 : F.value[at(p)]});
      }
    }
  }
  std::vector<int> merged;
  const auto merge = [&](const std::vector<int>& more, std::vector<int>& into) {
    merged.clear();
    std::ranges::set_union(more, into, std::back_inserter(merged));
    into = merged;
  };
  std::vector<int> own;
  for (std::int64_t s = 0; s < fronts_; ++s) {
    own.clear();
    for (const RightHandSideEntryInFront& entry : own_[at(s)]) {
      own.push_back(entry.column);
    }
    std::ranges::sort(own);
    own.erase(std::unique(own.begin(), own.end()), own.end());
    merge(own, columns_[at(s)]);
    // The front of the first row below has all rows that are left among its own: the parent.
    const SupernodeSize shape = shape_of(L_, s);
    if (shape.below > 0 && *below_of(L_, s) < L_.locals && !columns_[at(s)].empty()) {
      merge(columns_[at(s)], columns_[at(front_of_[at(*below_of(L_, s))])]);
    }
  }
}

// Flops, and the blocks that are there at a time, as run() goes.
void RowElimination::count_cost() {
  std::vector<bool> there(at(fronts_), false);
  double held = 0.0;
  const auto bytes = [&](std::int64_t s) {
    return 8.0 * shape_of(L_, s).columns * static_cast<double>(columns_[at(s)].size());
  };
  const auto make = [&](std::int64_t s) {
    held += s < 0 || there[at(s)] ? 0.0 : bytes(s);
    if (s >= 0) {
      there[at(s)] = true;
    }
  };
  for (std::int64_t s = 0; s < fronts_; ++s) {
    const auto k = static_cast<double>(columns_[at(s)].size());
    if (k == 0.0) {
      continue;
    }
    const SupernodeSize shape = shape_of(L_, s);
    const double c = shape.columns;
    flops_ += k * c * (c + 2.0 * shape.below + k);
    make(s);
    for_fronts_above(L_, front_of_, s, [&](std::int64_t above, int, int) { make(above); });
    const double rows = std::max(static_cast<double>(shape.below), k);
    workspace_ = std::max(workspace_, held + 8.0 * panel * rows);
    held -= bytes(s);
  }
}

base::Matrix& RowElimination::block_of(std::int64_t front) {
  base::Matrix& X = block_[at(front)];
  if (X.size() == 0) {
    X = base::Matrix::Zero(shape_of(L_, front).columns, index(columns_[at(front)].size()));
  }
  return X;
}

base::Matrix RowElimination::compute_compliance(base::Matrix& condensed, int threads) {
  blas::force_single_blas_thread();
  threads_ = threads;
  const Eigen::Index k = condensed.cols();
  base::Matrix W = base::Matrix::Zero(k, k);
  for (std::int64_t s = 0; s < fronts_; ++s) {
    if (!columns_[at(s)].empty()) {
      eliminate(s, W, condensed);
    }
  }
  W.triangularView<Eigen::StrictlyUpper>() = W.transpose();
  return W;
}

void RowElimination::eliminate(std::int64_t front, base::Matrix& W, base::Matrix& condensed) {
  const std::vector<int>& columns = columns_[at(front)];
  base::Matrix X = std::move(block_of(front));
  block_[at(front)] = base::Matrix();
  for (const RightHandSideEntryInFront& entry : own_[at(front)]) {
    const auto place = std::ranges::lower_bound(columns, entry.column) - columns.begin();
    X(entry.row, place) += entry.value;
  }
  const SupernodeSize shape = shape_of(L_, front);
  const double* const L = L_.value + L_.value_start[front];
  const auto k = static_cast<int>(columns.size());
  // Of one panel of columns all that touches no other's.
  const double flops = static_cast<double>(shape.columns) * std::min(k, panel);
  for_column_panels(k, flops * shape.columns, threads_, [&](int first, int width) {
    blas::solve_lower(
        shape.columns, width, blas::Transposition::plain, {L, shape.columns + shape.below},
        {X.data() + static_cast<std::ptrdiff_t>(first) * shape.columns, shape.columns});
  });
  for_column_panels(k, flops * k, threads_,
                    [&](int first, int width) { add_gram(X, columns, first, width, W); });
  if (shape.below > 0) {
    // Blocks above are made before several threads write into them.
    for_fronts_above(L_, front_of_, front, [&](std::int64_t above, int, int) {
      if (above >= 0) {
        block_of(above);
      }
    });
    for_column_panels(k, 2.0 * flops * shape.below, threads_,
                      [&](int first, int width) { hand_up(front, X, first, width, condensed); });
  }
}

// What is left of F in the rows of the fronts above, in columns [first, first + width) of X.
void RowElimination::hand_up(std::int64_t front, const base::Matrix& X, int first, int width,
                             base::Matrix& condensed) {
  const SupernodeSize shape = shape_of(L_, front);
  const std::vector<int>& columns = columns_[at(front)];
  const double* const L21 = L_.value + L_.value_start[front] + shape.columns;
  const std::int64_t* const row = below_of(L_, front);
  base::Matrix update(shape.below, width);
  std::vector<int> place;
  blas::gemm({.m = shape.below, .n = width, .k = shape.columns}, {L21, shape.columns + shape.below},
             {X.data() + static_cast<std::ptrdiff_t>(first) * shape.columns, shape.columns},
             {update.data(), shape.below});
  for_fronts_above(L_, front_of_, front, [&](std::int64_t above, int begin, int end) {
    const std::int64_t top = above < 0 ? L_.locals : L_.column[above];
    base::Matrix& into = above < 0 ? condensed : block_[at(above)];
    if (above >= 0) {
      find_places(columns, columns_[at(above)], place);
    }
    for (int j = 0; j < width; ++j) {
      const int column = above < 0 ? columns[at(first + j)] : place[at(first + j)];
      double* const to = into.data() + static_cast<std::ptrdiff_t>(column) * into.rows() - top;
      for (int i = begin; i < end; ++i) {
        to[row[i]] -= update(i, j);
      }
    }
  });
}

} // namespace spricka::solve
