// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "archive/checkpoint.hpp"
#include "base/outcome.hpp"
#include "program/job/ready_deck.hpp"
#include "program/job/run_options.hpp"

#include <filesystem>
#include <memory>
#include <optional>

/// What $RESTART, --restart and --time ask for.
namespace spricka::program {

/// Whether --restart or --time is given for a deck that keeps no state; it is told.
bool reject_restart_without_state(const RunOptions& options, const model::Model& model,
                                  const Log& log);

/// Throws FileFailure E469 when the deck keeps its state inside the run folder, which is replaced
/// as a whole while the state is written.
void reject_state_in_run_folder(const RunOptions& options, const model::Model& model);

struct CheckpointOrRefusal {
  std::unique_ptr<archive::Checkpoint> checkpoint; ///< null: nothing is asked for
  std::optional<RunOutcomeWithResults> refusal;    ///< the state does not fit the deck; it is told
};

/// Opens what deck and command line ask for. Files lie relative to the deck, those of a sweep's
/// point in `folder`. Throws FileFailure for files that cannot be used.
CheckpointOrRefusal open_checkpoint(const RunOptions& options, const CheckedDeck& deck,
                                    const std::filesystem::path& folder, const Log& log);

/// What a checkpoint (or null) passes over is said on stderr from now on, as it turns out.
void start_reporting_skipped_state(archive::Checkpoint* checkpoint, const Log& log);
/// Puts the last increments on disk, and what was taken over or passed over into the run's log.
void finish_checkpoint(archive::Checkpoint* checkpoint, results::RunResult& run);

/// Puts what is finished on disk and says so: how a run ends that is stopped by a signal or its
/// time limit. Empty: nothing is finished yet. From any thread.
std::optional<base::ProgramOutcome> stop_with_checkpoint(archive::Checkpoint& checkpoint,
                                                         const std::string& by, const Log& log);

/// Name of a signal, "SIGTERM"; "signal 65" where it has none.
std::string signal_name(int signal);

} // namespace spricka::program
