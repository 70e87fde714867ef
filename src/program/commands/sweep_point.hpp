// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "archive/checkpoint.hpp"
#include "base/outcome.hpp"
#include "program/job/job.hpp"
#include "program/job/point_record.hpp"
#include "program/job/run_folder.hpp"
#include "program/job/run_options.hpp"
#include "results/sweep.hpp"

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace spricka::program {

/// Computes points of a sweep, one at a time, each into a folder of its own with its record: the
/// run folder 007 of one that has results, 007.failed with nothing but the record of one that has
/// none. What goes wrong is in the point.
class SweepPointSolver {
public:
  /// `out`: the folder of the sweep. What the deck was found wrong in is not said again.
  SweepPointSolver(const RunOptions& options, const CheckedDeck& deck, const Log& log,
                   std::filesystem::path out)
      : options_(options), deck_(deck), log_(log), out_(std::move(out)) {}

  /// Solves the deck with these values. Of the point number, folder and values are known.
  void compute(const SweepPointValues& values, results::SweepPoint& point);

  /// The record of the point if it is finished: its values, deck and program are the same. With
  /// `failures` also that of one that was tried and has no results.
  [[nodiscard]] std::optional<results::SweepPoint>
  find(const SweepPointValues& values, const std::string& folder, bool failures) const;

  /// The program ends now, by a signal, from any thread: nothing half done is left, and finished
  /// increments are kept. Empty: there are none. Nothing is computed after it.
  std::optional<base::ProgramOutcome> abandon(int signal);

private:
  void solve_point(const SweepPointValues& values, results::SweepPoint& point);
  RunOutcomeWithResults solve(const RunOptions& options, const CheckedDeck& deck,
                              const results::SweepPoint& point);
  [[nodiscard]] CheckedDeck read_point(const RunOptions& options,
                                       const SweepPointValues& values) const;
  void keep_failure(const SweepPointValues& values, const results::SweepPoint& point) const;
  void open_point(const results::SweepPoint& point);
  void close_point();
  void set_current(archive::Checkpoint* checkpoint);

  const RunOptions& options_;
  const CheckedDeck& deck_;
  const Log& log_;
  std::filesystem::path out_;
  std::mutex current_guard_;
  archive::Checkpoint* current_ = nullptr; ///< of the point that is computed; guarded
  std::optional<RunFolder> folder_;        ///< of the same; guarded where it is made and ended
};

} // namespace spricka::program
