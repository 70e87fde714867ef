// SPDX-License-Identifier: GPL-3.0-or-later
// One factorisation on many threads: the stiffness of all bodies of a deck, externals last,
// factorised on one thread beside CHOLMOD's own numeric phase; then how long it takes on more
// threads, by the measured times of its tasks in the order in which threads would take them. Usage:
// bench_factor_threads DECK [EXTERNALS]
#include "analysis/bodies/whole_stiffness.hpp"
#include "discretised_deck.hpp"
#include "solve/blas.hpp"
#include "solve/cholmod_session.hpp"
#include "solve/factor_checks.hpp"
#include "solve/ordering.hpp"
#include "solve/supernodal_cholesky.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <queue>
#include <vector>

#include <fmt/format.h>

namespace {

using namespace spricka;

std::size_t at(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

/// When threads would be done with what they share: the pieces and tiles of a factor by the time
/// that each has taken, a tile's by its flops part for part.
class Schedule {
public:
  Schedule(const solve::FactorPanels& cut, const std::vector<double>& seconds)
      : cut_(cut), seconds_(seconds) {}

  double end(int threads) {
    idle_ = threads;
    now_ = 0.0;
    done_.assign(cut_.pieces().size(), false);
    diagonal_.assign(cut_.pieces().size(), false);
    left_.clear();
    tile_.assign(cut_.tiles().size(), {});
    own_.assign(cut_.tiles().size(), 0);
    for (std::size_t i = 0; i < cut_.pieces().size(); ++i) {
      const auto& piece = cut_.pieces()[i];
      left_.push_back(piece.tile_end - piece.tile_begin);
      for (std::int32_t t = piece.tile_begin; t < piece.tile_end; ++t) {
        own_[at(t)] = i;
        tile_[at(t)].next = cut_.updates_begin(at(cut_.tiles()[at(t)].panel));
      }
    }
    for (std::size_t i = 0; i < cut_.pieces().size(); ++i) {
      offer(i);
    }
    for (start(); !running_.empty(); start()) {
      const Event event = running_.top();
      running_.pop();
      now_ = event.end;
      ++idle_;
      finish(event.task);
    }
    return now_;
  }

private:
  struct Tile {
    const solve::PanelUpdate* next = nullptr;
    const solve::PanelUpdate* until = nullptr; ///< of those in hand
    bool busy = false, updated = false;
  };
  struct Event {
    double end;
    std::size_t task;
    bool operator<(const Event& other) const { return end > other.end; }
  };

  const solve::PanelUpdate* ready_end(std::size_t t) const {
    const solve::PanelUpdate* end = tile_[t].next;
    const solve::PanelUpdate* const last = cut_.updates_end(at(cut_.tiles()[t].panel));
    while (end < last && done_[at(cut_.piece_of(end->panel))]) {
      ++end;
    }
    return end;
  }
  void push(std::size_t task, std::size_t piece) {
    ready_.emplace(cut_.pieces()[piece].path, task);
  }
  void offer(std::size_t i) {
    const auto& piece = cut_.pieces()[i];
    if (piece.is_subtree()) {
      push(i, i);
      return;
    }
    for (std::int32_t t = piece.tile_begin; t < piece.tile_end; ++t) {
      Tile& tile = tile_[at(t)];
      const bool nothing = tile.next == cut_.updates_end(at(cut_.tiles()[at(t)].panel));
      if (!tile.busy && !tile.updated && (nothing || ready_end(at(t)) != tile.next)) {
        tile.busy = true;
        push(cut_.pieces().size() + at(t), i);
      }
    }
  }
  double update_flops(std::size_t t, const solve::PanelUpdate* from,
                      const solve::PanelUpdate* to) const {
    double flops = 0.0;
    const auto& tile = cut_.tiles()[t];
    const auto& p = cut_.panels()[at(tile.panel)];
    for (; from < to; ++from) {
      const auto& d = cut_.panels()[at(from->panel)];
      const auto* const begin = std::lower_bound(d.row, d.row + d.rows, p.row[tile.begin]);
      const auto* const end = std::upper_bound(begin, d.row + d.rows, p.row[tile.end - 1]);
      flops += 1e3 + 2.0 * static_cast<double>(end - begin) * (from->end - from->begin) * d.columns;
    }
    return flops;
  }
  double last_flops(std::size_t t) const {
    const auto& tile = cut_.tiles()[t];
    const auto& p = cut_.panels()[at(tile.panel)];
    return p.external ? 0.0 : 1.0 * (tile.end - tile.begin) * p.columns * p.columns;
  }
  // Takes ready tasks as long as threads are idle.
  void start() {
    while (idle_ > 0 && !ready_.empty()) {
      const std::size_t task = ready_.top().second;
      ready_.pop();
      --idle_;
      double took = 0.0;
      if (task < cut_.pieces().size()) {
        took = seconds_[task];
      } else {
        const std::size_t t = task - cut_.pieces().size();
        const auto* const all = cut_.updates_end(at(cut_.tiles()[t].panel));
        const double sum = update_flops(t, cut_.updates_begin(at(cut_.tiles()[t].panel)), all) +
                           last_flops(t) + 1.0;
        tile_[t].until = ready_end(t);
        const double part =
            tile_[t].updated ? last_flops(t) : update_flops(t, tile_[t].next, tile_[t].until);
        took = seconds_[task] * part / sum;
      }
      running_.push({now_ + took, task});
    }
  }
  void finish(std::size_t task) {
    if (task < cut_.pieces().size()) {
      end_piece(task);
      return;
    }
    const std::size_t t = task - cut_.pieces().size();
    Tile& tile = tile_[t];
    const std::size_t own = own_[t];
    if (!tile.updated) {
      tile.next = tile.until;
      tile.updated = tile.next == cut_.updates_end(at(cut_.tiles()[t].panel));
      const bool more = ready_end(t) != tile.next;
      const bool last = tile.updated && (cut_.tiles()[t].has_diagonal() || diagonal_[own] ||
                                         cut_.panels()[at(cut_.tiles()[t].panel)].external);
      tile.busy = more || last;
      if (tile.busy) {
        push(task, own);
      }
      return;
    }
    if (cut_.tiles()[t].has_diagonal()) {
      diagonal_[own] = true;
      for (std::int32_t o = cut_.pieces()[own].tile_begin + 1; o < cut_.pieces()[own].tile_end;
           ++o) {
        if (tile_[at(o)].updated && !tile_[at(o)].busy) {
          tile_[at(o)].busy = true;
          push(cut_.pieces().size() + at(o), own);
        }
      }
    }
    if (--left_[own] == 0) {
      end_piece(own);
    }
  }
  void end_piece(std::size_t piece) {
    done_[piece] = true;
    for (const std::int32_t other : cut_.pieces()[piece].updated) {
      offer(at(other));
    }
  }

  const solve::FactorPanels& cut_;
  const std::vector<double>& seconds_;
  int idle_ = 0;
  double now_ = 0.0;
  std::vector<char> done_, diagonal_;
  std::vector<int> left_;
  std::vector<Tile> tile_;
  std::vector<std::size_t> own_;
  std::priority_queue<std::pair<double, std::size_t>> ready_;
  std::priority_queue<Event> running_;
};

int measure(base::SymmetricCsc K, std::int64_t externals, int repeats) {
  solve::blas::force_single_blas_thread(); // or its threads would work beside the one that is
                                           // measured
  const std::int64_t locals = K.n - externals;
  std::vector<std::int64_t> order =
      solve::elimination_order(K, locals, solve::OrderingMethod::automatic);
  solve::CholmodSession session;
  session->supernodal = CHOLMOD_SUPERNODAL;
  session->nmethods = 1;
  session->method[0].ordering = CHOLMOD_GIVEN;
  session->postorder = 0;
  session->final_ll = 1;
  cholmod_sparse view =
      solve::cholmod_lower_view(K.n, K.start.data(), K.row.data(), K.value.data());
  cholmod_factor* factor = cholmod_l_analyze_p(&view, order.data(), nullptr, 0, session.get());
  const auto integers = [](void* p) { return static_cast<const std::int64_t*>(p); };
  std::vector<double> values(factor->xsize);
  const solve::SupernodalFactor L{.n = K.n,
                                  .locals = locals,
                                  .count = static_cast<std::int64_t>(factor->nsuper),
                                  .column = integers(factor->super),
                                  .row_start = integers(factor->pi),
                                  .value_start = integers(factor->px),
                                  .row = integers(factor->s),
                                  .value = values.data()};
  const double flops = session->fl;
  const solve::FactorPanels panels(L);
  const base::SymmetricCsc A = solve::reorder(K, order, K.n);
  double own = 0.0;
  double cholmod = 0.0;
  std::unique_ptr<solve::SupernodalCholesky> best;
  for (int i = 0; i < repeats; ++i) {
    auto once = std::make_unique<solve::SupernodalCholesky>(panels, values.data(), A);
    once->factorise(1);
    if (!best || once->cpu_seconds() < own) {
      own = once->cpu_seconds();
      best = std::move(once);
    }
    const double begun = solve::thread_cpu_seconds();
    cholmod_l_factorize(&view, factor, session.get());
    const double took = solve::thread_cpu_seconds() - begun;
    cholmod = i == 0 ? took : std::min(cholmod, took);
  }
  cholmod_l_free_factor(&factor, session.get());
  fmt::print("{} unknowns, {} externals, {:.3g} flops; {:.3g} of panels\n", K.n, externals, flops,
             panels.flops());
  fmt::print("one thread: {:.3f} s, {:.1f} Gflop/s; CHOLMOD's numeric phase with the externals "
             "eliminated too {:.3f} s: {:.2f}\n",
             own, 1e-9 * panels.flops() / own, cholmod, own / cholmod);
  Schedule schedule(panels, best->task_seconds());
  const double alone = schedule.end(1);
  for (const int threads : {1, 2, 3, 4, 8, 16, 32, 1000}) {
    const double end = schedule.end(threads);
    fmt::print("{:>4} threads: {:.3f} s, {:.2f} times as fast\n", threads, end, alone / end);
  }
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  const bench::DiscretisedDeck deck(argc > 1 ? argv[1] : nullptr,
                                    "bench_factor_threads DECK [EXTERNALS [REPEATS]]");
  if (deck.exit_code() != 0) {
    return deck.exit_code();
  }
  return measure(analysis::regularised_global_stiffness(deck.model(), deck.scene()),
                 argc > 2 ? std::atol(argv[2]) : 0, argc > 3 ? std::atoi(argv[3]) : 3);
}
