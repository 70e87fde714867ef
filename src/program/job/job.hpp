// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "model/forward.hpp"
#include "program/job/log.hpp"
#include "program/job/ready_deck.hpp"
#include "program/job/run_folder.hpp"
#include "program/job/run_options.hpp"
#include "results/results.hpp"

#include <filesystem>
#include <optional>
#include <string>

/// One deck, read, solved and written once: what `run` does, and a sweep for each of its points.
namespace spricka::archive {
class Checkpoint;
}

namespace spricka::program {

/// Solves a deck and writes its folder (null: no file is written), which is not yet put in place;
/// messages go to the log. With a checkpoint (or null) what an earlier run has solved is taken
/// over, and increments are kept. Throws std::system_error or FileFailure when a file cannot be
/// written.
RunOutcomeWithResults solve_and_write(const RunOptions& options, const CheckedDeck& deck,
                                      RunFolder* folder, archive::Checkpoint* checkpoint,
                                      const Log& log);

/// What bodies have of cracks in space, and the table of results, on stdout.
void print_summary(const CheckedDeck& deck, const results::RunResult& run,
                   const std::filesystem::path& folder);

} // namespace spricka::program
