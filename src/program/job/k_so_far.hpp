// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "program/job/run_folder.hpp"
#include "results/results.hpp"

namespace spricka::program {

/// Keeps k.csv of a run under way up to date: K of all increments that are finished, and of the
/// steps of the one that is not.
class InterimKTable {
public:
  InterimKTable(const model::Model& model, RunFolder& folder) : model_(model), folder_(folder) {}

  /// The increment under way has a new K, or a bar of one.
  void update_increment(const results::Increment& increment);
  /// How many increments of the run are finished; their K stays in the table.
  void set_finished_increments(std::size_t increments) { finished_ = increments; }

private:
  const model::Model& model_;
  RunFolder& folder_;
  results::RunResult run_; ///< K alone
  std::size_t finished_ = 0;
};

} // namespace spricka::program
