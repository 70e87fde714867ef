// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/supernodal_cholesky.hpp"
#include "base/index.hpp"
#include "solve/factor_checks.hpp"

#include <algorithm>
#include <numeric>

namespace spricka::solve {

using base::at;

namespace {

// With less to do a second thread would come too late.
constexpr double least_threaded_flops = 1e8;

} // namespace

SupernodalCholesky::SupernodalCholesky(const FactorPanels& cut, double* values,
                                       const base::SymmetricCsc& A)
    : elimination_(cut, values, A), cut_(cut), tile_(cut_.tiles().size()),
      piece_(cut_.pieces().size()), own_piece_(cut_.tiles().size()), failed_(cut.columns()),
      seconds_(cut_.pieces().size() + cut_.tiles().size(), 0.0) {}

std::int64_t SupernodalCholesky::factorise(int threads) {
  const std::vector<FactorPanels::Piece>& pieces = cut_.pieces();
  const auto workers =
      static_cast<std::size_t>(cut_.flops() < least_threaded_flops ? 1 : std::max(1, threads));
  std::vector<PanelWorkspace> work(workers);
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
    PanelWorkspace& own = work[worker];
    const double begun = thread_cpu_seconds();
    own.place.resize(at(cut_.columns()));
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

// Whether all pivots of a panel's own block are positive.
bool SupernodalCholesky::factorise_diagonal(const FactorPanel& p) {
  const std::int64_t stop = elimination_.factorise_diagonal(p);
  if (stop == p.first + p.columns) {
    return true;
  }
  const std::lock_guard<std::mutex> guard(lock_);
  failed_ = std::min(failed_, stop);
  return false;
}

void SupernodalCholesky::eliminate_subtree(std::size_t piece, PanelWorkspace& work) {
  const FactorPanels::Piece& subtree = cut_.pieces()[piece];
  for (std::int32_t i = subtree.first; i <= subtree.last; ++i) {
    const FactorPanel& p = cut_.panels()[at(i)];
    const PanelTile whole{i, 0, p.rows};
    elimination_.begin_tile(whole);
    elimination_.take_off(whole, {cut_.updates_begin(at(i)), cut_.updates_end(at(i))}, work);
    if (!factorise_diagonal(p)) {
      return; // what waits for it stays undone
    }
    elimination_.eliminate_below(p, p.columns, p.rows);
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
void SupernodalCholesky::work_on_tile(std::size_t t, PanelWorkspace& work) {
  const PanelTile& tile = cut_.tiles()[t];
  TileState& state = tile_[t];
  if (!state.begun) {
    elimination_.begin_tile(tile);
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
    elimination_.take_off(tile, updates, work);
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
    elimination_.eliminate_below(p, p.columns, tile.end);
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
    elimination_.eliminate_below(p, tile.begin, tile.end);
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
void SupernodalCholesky::make_ready(std::size_t number) {
  const FactorPanels::Piece& piece = cut_.pieces()[number];
  if (piece.is_subtree()) {
    queue_.push(number, piece.path); // a subtree waits for nothing
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
