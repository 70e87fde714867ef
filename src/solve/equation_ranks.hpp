// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/sparse.hpp"
#include "solve/communicator.hpp"
#include "solve/condensed_equations.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <shared_mutex>
#include <span>
#include <string>
#include <vector>

namespace spricka::solve {

class RankMessages;

/// What a rank has done for the run, for the listing.
struct RankWork {
  std::string machine;
  int nets = 0;                 ///< condensed there
  int nets_of_all = 0;          ///< of these, by all ranks together
  std::int64_t unknowns = 0;    ///< of these
  double forecast_memory = 0.0; ///< [bytes] largest need, from the symbolic phases
  double peak_memory = 0.0;     ///< [bytes] largest resident set
  double cpu = 0.0;             ///< [s] of its process
};

/// The ranks of a run as rank 0 sees them: it hands nets out, they keep the factors and answer. No
/// bit of what Cholesky answers hangs on where it was asked. Any thread may call.
class EquationRanks {
public:
  /// The other ranks must be in serve_rank().
  explicit EquationRanks(Communicator& communicator);
  ~EquationRanks(); // NOLINT(performance-trivially-destructible)
  EquationRanks(const EquationRanks&) = delete;
  EquationRanks& operator=(const EquationRanks&) = delete;

  [[nodiscard]] int count() const { return static_cast<int>(ranks_.size()); }
  /// Ranks on the machine of rank 0.
  [[nodiscard]] int on_own_machine() const { return communicator_.ranks_on_machine(); }
  /// By Cholesky in core, as condense_equations, on the rank that for_each_on_ranks() has chosen;
  /// K stays whole.
  [[nodiscard]] std::unique_ptr<CondensedEquations>
  condense_elsewhere(const base::SymmetricCsc& K, std::int64_t externals,
                     const CondensationSettings& settings);
  /// By MUMPS, all ranks together, as condense_equations. K is moved from; it is given back where
  /// the status is not ok.
  [[nodiscard]] std::unique_ptr<CondensedEquations>
  condense_together(base::SymmetricCsc& K, std::int64_t externals,
                    const CondensationSettings& settings);
  /// Counts a net that rank 0 has condensed itself, beside `others` [bytes] that it held.
  void count_own_net(std::int64_t unknowns, const FactorReport& report, double others);
  /// Counts what rank 0 was to take [bytes] for rows of contact, beside the `resident` before.
  void count_own_rows(double resident, double memory);

  /// [rank] what each has done until now.
  [[nodiscard]] std::vector<RankWork> work();
  /// Sends the others home with an exit code; nothing may be asked of them from then on.
  void end(int exit_code);

private:
  friend class RemoteEquations;
  struct Rank {
    std::mutex asking; ///< one question and its answer at a time
    RankWork work;
    double memory_before = 0.0; ///< [bytes] resident before the first net
    double kept = 0.0;          ///< [bytes] of the factors that it holds
  };
  /// One question to another rank and its answer.
  void converse(int rank, const std::function<void(RankMessages&)>& talk);
  void take_step(std::int64_t matrix, int job, const std::function<void()>& own_part);
  void release(int rank, std::int64_t number, double kept);
  void count_rows(int rank, double memory);

  Communicator& communicator_;
  std::vector<std::unique_ptr<Rank>> ranks_;
  std::shared_mutex together_; ///< held alone while all ranks work on one matrix
  std::atomic<std::int64_t> next_ = 0;
  std::atomic<bool> ended_ = false;
};

/// What this process holds [bytes] beside a factor that has just been made.
double resident_beside(const FactorReport& report);

/// Those of this process, or null: it works alone, as nearly always.
EquationRanks* equation_ranks();
/// Called once, before anything is solved; null when they end.
void set_equation_ranks(EquationRanks* ranks);

/// Calls task(i) once for each cost: what those condense is condensed by the ranks, side by side.
/// Those of rank 0 are called on at most `threads` threads, those of another rank one after
/// another, on a thread that mostly waits for it. In a run of one process
/// that is base::parallel_for.
void for_each_on_ranks(std::span<const double> cost, int threads,
                       const std::function<void(std::size_t)>& task);
/// Whether what the calling thread condenses is condensed on another rank.
bool condenses_elsewhere();

/// Hands out tasks of these costs to `ranks` ranks, the dearest first, each to the rank that has
/// least to do, the lowest of equals: [task] its rank.
std::vector<int> distribute_by_cost(std::span<const double> cost, int ranks);

} // namespace spricka::solve
