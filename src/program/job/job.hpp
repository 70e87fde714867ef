// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "base/source.hpp"
#include "deck/read_deck.hpp"
#include "model/model.hpp"
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

struct RunOutcome {
  int exit_code = 0;
  std::string error; ///< the first one, with its place, or how many checks failed
  std::optional<results::Run> run;
};

/// A deck that has been read: fit to be solved (model) or refused with an exit code.
struct ReadyDeck {
  base::Sources sources;
  base::Diagnostics diagnostics;          ///< of reading
  deck::ReadOptions options;              ///< as it was read
  std::vector<deck::ScriptTable> scripts; ///< the constants of geometry scripts
  std::optional<model::Model> model;
  RunOutcome refusal; ///< without a model
};

/// Reads and checks a deck; messages go to the log. Cards that this version does not have are
/// refused (not_solvable), so is a deck without a step. Throws std::system_error on file trouble.
/// What was `told` already is not said again, as of the other points of a sweep.
ReadyDeck read_ready(const std::filesystem::path& deck, const deck::ReadOptions& options,
                     const Log& log, const base::Diagnostics* told = nullptr);

/// Solves a deck and writes its folder, which is not yet put in place; messages go to the log. With
/// a checkpoint (or null) what an earlier run has solved is taken over, and increments are kept.
/// Throws std::system_error or FileTrouble when a file cannot be written.
RunOutcome solve_and_write(const RunOptions& options, const ReadyDeck& deck, RunFolder& folder,
                           archive::Checkpoint* checkpoint, const Log& log);

/// The table of results on stdout.
void print_summary(const model::Model& model, const results::Run& run,
                   const std::filesystem::path& folder);

/// As the command line says, else $CONTROL; 0 means all cores.
int thread_count(const RunOptions& options, const model::Model& model);

} // namespace spricka::program
