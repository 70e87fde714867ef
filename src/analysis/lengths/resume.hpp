// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/lengths/pictured_steps.hpp"
#include "analysis/lengths/solve_options.hpp"
#include "archive/increment_store.hpp"
#include "archive/safe_file.hpp"
#include "base/clock.hpp"
#include "base/damaged_field.hpp"
#include "base/outcome.hpp"

#include <optional>
#include <string>
#include <vector>

/// What the loops over crack lengths do with a checkpoint; all of it may be null.
namespace spricka::analysis {

/// Increment `number`, asked for length `asked`, from an earlier run; empty: it is to be solved.
/// Its stresses are those of the steps in `pictured`; where one is missing it is solved anew.
std::optional<archive::StoredIncrement> accept_stored_increment(const model::Model& model,
                                                                archive::IncrementStore* checkpoint,
                                                                int number, double asked,
                                                                const PicturedSteps& pictured);

/// What `take` makes of the state that was kept; where that lacks something, or names what is not
/// there, the file is in trouble: throws FileFailure E560, which names the field.
template <class Take> auto restore_or_report_damage(const Take& take) {
  try {
    return take();
  } catch (const base::CorruptStoredField& trouble) {
    throw archive::FileFailure("E560", std::string("the state in the restart file is damaged: ") +
                                           trouble.what());
  }
}

/// Adds it to a run as if it had been solved now.
void append_increment(archive::StoredIncrement kept, results::RunResult& run);

/// Tells of the last increment of a run, which was taken over, as if it had been solved, of so many
/// in all.
void report_resumed_increment(const SolveOptions& options, const results::RunResult& run,
                              std::size_t increments);

/// Whether the time is up before the next increment; then `trouble` says so.
bool is_time_up(const archive::IncrementStore* checkpoint, base::OptionalFailure& trouble);

/// Where a loop stood when it began with an increment.
class IncrementRecorder {
public:
  explicit IncrementRecorder(const std::vector<results::LogLine>& log)
      : log_(log), lines_(log.size()) {}
  /// Keeps the increment that was solved since, with the log's lines since then.
  void store_increment(archive::IncrementStore* checkpoint, double asked,
                       const results::CrackLengthResult& increment,
                       results::NamedArrays state) const;

private:
  const std::vector<results::LogLine>& log_;
  std::size_t lines_;
  base::Stopwatch watch_;
};

} // namespace spricka::analysis
