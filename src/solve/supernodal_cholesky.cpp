// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/supernodal_cholesky.hpp"
#include "base/index.hpp"
#include "solve/blas.hpp"
#include "solve/factor_checks.hpp"

#include <algorithm>
#include <numeric>

namespace spricka::solve {

using base::at;

namespace {

// Up to so many columns a block on the diagonal is multiplied with what is below it at once: half
// of it in vain, but by one call.
constexpr int one_product = 32;
// With less to do a second thread would come too late.
constexpr double least_threaded_flops = 1e8;

} // namespace

SupernodalCholesky::SupernodalCholesky(const FactorPanels& cut, double* values,
                                       const base::SymmetricCsc& A)
    : values_(values), A_(A), cut_(cut), tile_(cut_.tiles().size()), piece_(cut_.pieces().size()),
      own_piece_(cut_.tiles().size()), failed_(cut.columns()),
      seconds_(cut_.pieces().size() + cut_.tiles().size(), 0.0) {}

std::int64_t SupernodalCholesky::factorise(int threads) {
  const std::vector<FactorPanels::Piece>& pieces = cut_.pieces();
  const auto workers =
      static_cast<std::size_t>(cut_.flops() < least_threaded_flops ? 1 : std::max(1, threads));
  std::vector<Workspace> work(workers);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    piece_[i].tiles_left = pieces[i].tile_end - pieces[i].tile_begin;
    for (std::int32_t t = pieces[i].tile_begin; t < pieces[i].tile_end; ++t) {
      own_piece_[at(t)] = i;
      tile_[at(t)].next = cut_.updates_begin(at(pieces[i].first));
    }
  }
  // Numbers of tasks: pieces, then tiles.
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    make_ready(i);
  }
  queue_.run(static_cast<int>(workers), [&](std::size_t task, std::size_t worker) {
    Workspace& own = work[worker];
    const double begun = thread_cpu_seconds();
    own.place.resize(at(A_.n));
    if (task < pieces.size()) {
      eliminate_subtree(task, own);
    } else {
      work_on_tile(task - pieces.size(), own);
    }
    seconds_[task] += thread_cpu_seconds() - begun;
  });
  return failed_;
}

double SupernodalCholesky::cpu_seconds() const {
  return std::accumulate(seconds_.begin(), seconds_.end(), 0.0);
}

// The entries of A in some rows of a panel, the others zero.
void SupernodalCholesky::begin_tile(const PanelTile& tile) {
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

void SupernodalCholesky::set_places(const PanelTile& tile, Workspace& work) const {
  const FactorPanel& p = cut_.panels()[at(tile.panel)];
  for (int i = tile.begin; i < tile.end; ++i) {
    work.place[at(p.row[i])] = i;
  }
}

void SupernodalCholesky::take_off(const PanelTile& tile, std::span<const PanelUpdate> updates,
                                  Workspace& work) {
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
void SupernodalCholesky::subtract_product(const FactorPanel& p, const FactorPanel& from,
                                          const PanelUpdate& u, int lo, int hi, Workspace& work) {
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

bool SupernodalCholesky::factorise_diagonal(const FactorPanel& p) {
  const int pivot = blas::cholesky_until(p.columns, {values_ + p.value, p.stride});
  if (pivot < p.columns) {
    const std::lock_guard<std::mutex> guard(lock_);
    failed_ = std::min(failed_, p.first + pivot);
    return false;
  }
  return true;
}

void SupernodalCholesky::eliminate_below(const FactorPanel& p, int begin, int end) {
  blas::solve_lower_from_right(end - begin, p.columns, {values_ + p.value, p.stride},
                               {values_ + p.value + begin, p.stride});
}

void SupernodalCholesky::eliminate_subtree(std::size_t piece, Workspace& work) {
  const FactorPanels::Piece& subtree = cut_.pieces()[piece];
  for (std::int32_t i = subtree.first; i <= subtree.last; ++i) {
    const FactorPanel& p = cut_.panels()[at(i)];
    const PanelTile whole{i, 0, p.rows};
    begin_tile(whole);
    take_off(whole, {cut_.updates_begin(at(i)), cut_.updates_end(at(i))}, work);
    if (!factorise_diagonal(p)) {
      return; // what waits for it stays undone
    }
    eliminate_below(p, p.columns, p.rows);
  }
  end_piece(piece);
}

// Those from the next on whose panels are eliminated. Under the lock.
std::span<const PanelUpdate> SupernodalCholesky::ready_updates(const PanelTile& tile,
                                                               const TileState& state) const {
  const PanelUpdate* end = state.next;
  const PanelUpdate* const last = cut_.updates_end(at(tile.panel));
  while (end < last && piece_[at(cut_.piece_of(end->panel))].done) {
    ++end;
  }
  return {state.next, end};
}

// Takes off what is ready to be; when that was all, eliminates.
void SupernodalCholesky::work_on_tile(std::size_t t, Workspace& work) {
  const PanelTile& tile = cut_.tiles()[t];
  TileState& state = tile_[t];
  if (!state.begun) {
    begin_tile(tile);
    state.begun = true;
  }
  while (!state.updated) {
    std::span<const PanelUpdate> updates;
    {
      const std::lock_guard<std::mutex> guard(lock_);
      updates = ready_updates(tile, state);
      state.updated = state.next == cut_.updates_end(at(tile.panel));
      if (updates.empty() && !state.updated) {
        state.busy = false; // until the next piece ends
        return;
      }
    }
    take_off(tile, updates, work);
    state.next += updates.size();
  }
  finish_tile(t);
}

void SupernodalCholesky::finish_tile(std::size_t t) {
  const PanelTile& tile = cut_.tiles()[t];
  const FactorPanel& p = cut_.panels()[at(tile.panel)];
  const std::size_t own = own_piece_[t];
  if (p.external) {
    end_tile(own);
    return;
  }
  if (tile.has_diagonal()) {
    if (!factorise_diagonal(p)) {
      return;
    }
    eliminate_below(p, p.columns, tile.end);
    const FactorPanels::Piece& piece = cut_.pieces()[own];
    const std::lock_guard<std::mutex> guard(lock_);
    piece_[own].has_diagonal = true;
    for (std::int32_t other = piece.tile_begin + 1; other < piece.tile_end; ++other) {
      if (tile_[at(other)].updated && !tile_[at(other)].busy) {
        tile_[at(other)].busy = true;
        queue_.push(cut_.pieces().size() + at(other), piece.path);
      }
    }
  } else {
    {
      const std::lock_guard<std::mutex> guard(lock_);
      if (!piece_[own].has_diagonal) {
        tile_[t].busy = false; // until the diagonal is
        return;
      }
    }
    eliminate_below(p, tile.begin, tile.end);
  }
  end_tile(own);
}

void SupernodalCholesky::end_tile(std::size_t piece) {
  bool last = false;
  {
    const std::lock_guard<std::mutex> guard(lock_);
    last = --piece_[piece].tiles_left == 0;
  }
  if (last) {
    end_piece(piece);
  }
}

void SupernodalCholesky::end_piece(std::size_t piece) {
  {
    const std::lock_guard<std::mutex> guard(lock_);
    piece_[piece].done = true;
  }
  for (const std::int32_t other : cut_.pieces()[piece].updated) {
    make_ready(at(other));
  }
}

// Makes ready what can be done for a piece now.
void SupernodalCholesky::make_ready(std::size_t i) {
  const FactorPanels::Piece& piece = cut_.pieces()[i];
  if (piece.is_subtree()) {
    queue_.push(i, piece.path); // a subtree waits for nothing
    return;
  }
  const std::lock_guard<std::mutex> guard(lock_);
  for (std::int32_t t = piece.tile_begin; t < piece.tile_end; ++t) {
    TileState& state = tile_[at(t)];
    const PanelTile& tile = cut_.tiles()[at(t)];
    if (state.busy || state.updated) {
      continue;
    }
    const bool nothing = state.next == cut_.updates_end(at(tile.panel));
    if (nothing || !ready_updates(tile, state).empty()) {
      state.busy = true;
      queue_.push(cut_.pieces().size() + at(t), piece.path);
    }
  }
}

} // namespace spricka::solve
