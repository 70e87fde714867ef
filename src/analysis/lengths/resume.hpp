// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "archive/checkpoint.hpp"
#include "base/clock.hpp"
#include "base/outcome.hpp"

#include <optional>
#include <vector>

/// What the loops over crack lengths do with a checkpoint; all of it may be null.
namespace spricka::analysis {

/// Increment `number`, asked for length `asked`, from an earlier run; empty: it is to be solved.
/// Its stresses are those of the steps in `pictured`; where one is missing it is solved anew.
std::optional<archive::KeptIncrement> resume(const model::Model& model,
                                             archive::Checkpoint* checkpoint, int number,
                                             double asked, const std::vector<bool>& pictured);

/// Adds it to a run as if it had been solved now.
void take_over(archive::KeptIncrement kept, results::Run& run);

/// Whether the time is up before the next increment; then `trouble` says so.
bool stop_here(const archive::Checkpoint* checkpoint, base::Trouble& trouble);

/// Where a loop stood when it began with an increment.
class IncrementMark {
public:
  explicit IncrementMark(const std::vector<results::LogLine>& log)
      : log_(log), lines_(log.size()) {}
  /// Keeps the increment that was solved since, with the log's lines since then.
  void keep(archive::Checkpoint* checkpoint, double asked, const results::Increment& increment,
            results::NamedArrays state) const;

private:
  const std::vector<results::LogLine>& log_;
  std::size_t lines_;
  base::Stopwatch watch_;
};

} // namespace spricka::analysis
