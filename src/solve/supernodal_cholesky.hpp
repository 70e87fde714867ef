// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/ready_queue.hpp"
#include "base/sparse.hpp"
#include "solve/factor_panels.hpp"
#include "solve/panel_elimination.hpp"

#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

namespace spricka::solve {

/// The numeric phase of a sparse Cholesky factorisation on the supernodes of its symbolic phase
/// (left-looking, supernode by supernode: Ng, E. G. and Peyton, B. W., Block sparse Cholesky
/// algorithms on advanced uniprocessor computers, SIAM J. Sci. Comput. 14, 1993), on several
/// threads. Locals are eliminated; of externals the block is left updated, as their Schur
/// complement. Every sum is taken in one order, so that no bit depends on the threads.
class SupernodalCholesky {
public:
  /// `values` of the factor that was cut up are written. A [n, n]: in the order of elimination,
  /// each entry once, in the column that is eliminated first (rows in any order). All must outlive
  /// this.
  SupernodalCholesky(const FactorPanels& cut, double* values, const base::SymmetricCsc& A);

  /// Factorises; the first column with a pivot that is not positive, n where there is none.
  /// Throws std::bad_alloc.
  std::int64_t factorise(int threads);
  /// Time [s] that its threads have taken of processors.
  [[nodiscard]] double cpu_seconds() const;
  /// The same by task: of each piece (of a subtree), then of each tile.
  [[nodiscard]] const std::vector<double>& task_seconds() const { return seconds_; }

private:
  struct TileState {
    const PanelUpdate* next = nullptr; ///< the first that has not been taken off yet
    bool begun = false;                ///< the entries of A are in
    bool busy = false;
    bool updated = false; ///< all updates are taken off
  };
  struct PieceState {
    bool done = false;
    bool has_diagonal = false; ///< its first tile is a factor
    int tiles_left = 0;
  };

  bool factorise_diagonal(const FactorPanel& p);
  void eliminate_subtree(std::size_t piece, PanelWorkspace& work);
  void work_on_tile(std::size_t tile, PanelWorkspace& work);
  [[nodiscard]] std::span<const PanelUpdate> ready_updates(const PanelTile& tile,
                                                           const TileState& state) const;
  void finish_tile(std::size_t tile);
  void end_tile(std::size_t piece);
  void end_piece(std::size_t piece);
  void make_ready(std::size_t number);

  PanelElimination elimination_;
  const FactorPanels& cut_;
  std::vector<TileState> tile_;
  std::vector<PieceState> piece_;
  std::vector<std::size_t> own_piece_; ///< [tile]
  base::ReadyQueue queue_;
  std::mutex lock_; ///< of the states
  std::int64_t failed_;
  std::vector<double> seconds_;
};

} // namespace spricka::solve
