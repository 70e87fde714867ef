// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/commands/sweep_point.hpp"

#include "analysis/lengths/recorder.hpp"
#include "archive/deck_digest.hpp"
#include "archive/folder_mark.hpp"
#include "archive/safe_file.hpp"
#include "model/model.hpp"
#include "program/job/failures.hpp"
#include "program/job/restart_run.hpp"
#include "program/profile/profile.hpp"
#include "report/sweep_files.hpp"

#include <algorithm>
#include <exception>
#include <system_error>

#include <fmt/format.h>

namespace spricka::program {

namespace {

namespace fs = std::filesystem;
using results::SweepPoint;

// What tables of the sweep show of a run, in its point.
void collect_values(const model::Model& model, const results::RunResult& run, SweepPoint& point) {
  point.checks = static_cast<int>(run.checks.size());
  point.passed = static_cast<int>(
      std::count_if(run.checks.begin(), run.checks.end(), [](const auto& c) { return c.passed; }));
  point.warnings = static_cast<int>(run.warnings.size());
  point.cells = report::collect_sweep_values_of_run(model, run);
  for (const model::OutputFileRequest& output : model.outputs) {
    if (output.format == model::OutputFormat::csv && output.every == model::OutputFrequency::end) {
      std::vector<results::SweepResultValue>& cells =
          point.requested[fs::path(output.file).filename().string()];
      const std::vector<results::SweepResultValue> more =
          report::collect_requested_end_values(model, output, run);
      cells.insert(cells.end(), more.begin(), more.end());
    }
  }
}

// What a record must agree in to stand for a point. An engine that was asked for may give other
// last digits than that which the program chooses.
std::string digest_of(const CheckedDeck& deck, const SweepPointValues& values,
                      const RunOptions& options) {
  const std::string digest = archive::compute_deck_digest(deck.sources, *deck.model, values);
  return options.engine.empty() ? digest : digest + ' ' + options.engine;
}

// A property of deck and machine, not of a disk or of another process.
bool is_failure_to_keep(base::ProgramOutcome outcome) {
  return outcome != base::ProgramOutcome::stopped && outcome != base::ProgramOutcome::file_trouble;
}

} // namespace

void SweepPointSolver::compute(const SweepPointValues& values, SweepPoint& point) {
  try {
    open_point(point);
    archive::remove_manifest_files(out_ / (point.folder + failed_point_ending));
    solve_point(values, point);
  } catch (const archive::FileFailure& trouble) {
    point.outcome = base::ProgramOutcome::file_trouble;
    point.error = fmt::format("{}: {}", trouble.code(), trouble.what());
    point.taken = trouble.code() == "E465";
  } catch (const std::system_error& trouble) {
    point.outcome = base::ProgramOutcome::file_trouble;
    point.error = trouble.what();
  } catch (const std::exception& trouble) {
    const bool memory = is_out_of_memory(trouble);
    point.outcome = memory ? base::ProgramOutcome::not_solvable : base::ProgramOutcome::defect;
    point.error = memory ? "E466: " + out_of_memory_message()
                         : fmt::format("internal error: {}", trouble.what());
  }
  if (!has_results(point.outcome) && is_failure_to_keep(point.outcome)) {
    keep_failure(values, point);
  }
  close_point();
}

std::optional<SweepPoint> SweepPointSolver::find(const SweepPointValues& values,
                                                 const std::string& folder, bool failures) const {
  const std::string digest = digest_of(deck_, values, options_);
  std::optional<SweepPoint> known = read_point_record(out_ / folder, digest);
  return known || !failures ? known
                            : read_point_record(out_ / (folder + failed_point_ending), digest);
}

void SweepPointSolver::solve_point(const SweepPointValues& values, SweepPoint& point) {
  RunOptions options = options_;
  options.quiet = true;
  // Each point has a profile of its own, from here on.
  options.recorder = options.profile ? begin_profile() : nullptr;
  const CheckedDeck deck = read_point(options, values);
  const RunOutcomeWithResults outcome = deck.model ? solve(options, deck, point) : deck.refusal;
  point.outcome = outcome.kind;
  point.error = outcome.error;
  if (outcome.run) {
    collect_values(*deck.model, *outcome.run, point);
    // The digest of what was read just now: a file edited meanwhile is not passed over later.
    folder_->add_file(point_record_name, point_record_text(values, point,
                                                           archive::compute_deck_digest(
                                                               deck.sources, *deck.model, values)));
    folder_->commit();
  } else if (folder_->replaces_earlier_run()) {
    log_.report_message(base::Severity::note, "E467",
                        fmt::format("{} still holds the results of an earlier run",
                                    (out_ / point.folder).string()));
  }
}

// So that who makes the tables knows why there is no result, whichever process has tried.
void SweepPointSolver::keep_failure(const SweepPointValues& values, const SweepPoint& point) const {
  try {
    RunFolder failure(out_ / (point.folder + failed_point_ending));
    failure.add_file(point_record_name,
                     point_record_text(values, point, digest_of(deck_, values, options_)));
    failure.commit();
  } catch (const std::exception&) {
    // A full disk: the point counts as not tried.
  }
}

CheckedDeck SweepPointSolver::read_point(const RunOptions& options,
                                         const SweepPointValues& values) const {
  const analysis::ScopedProfileInterval span(options.recorder.get(), "DECK", "deck and meshes");
  return read_and_check_deck(options.deck, {.defines = options.defines, .sweep_values = values},
                             log_, &deck_.diagnostics);
}

// Made and ended where abandon() knows of it.
void SweepPointSolver::open_point(const SweepPoint& point) {
  const std::scoped_lock lock(current_guard_);
  folder_.emplace(out_ / point.folder);
}

void SweepPointSolver::close_point() {
  const std::scoped_lock lock(current_guard_);
  folder_.reset();
}

// Each point keeps its state in a folder of its own, beside its run folder.
RunOutcomeWithResults SweepPointSolver::solve(const RunOptions& options, const CheckedDeck& deck,
                                              const SweepPoint& point) {
  const CheckpointOrRefusal opened =
      open_checkpoint(options, deck, out_ / (point.folder + ".restart"), log_);
  if (opened.refusal) {
    return *opened.refusal;
  }
  set_current(opened.checkpoint.get());
  try {
    RunOutcomeWithResults outcome =
        solve_and_write(options, deck, &*folder_, opened.checkpoint.get(), log_);
    set_current(nullptr);
    return outcome;
  } catch (...) {
    set_current(nullptr);
    throw;
  }
}

void SweepPointSolver::set_current(archive::Checkpoint* checkpoint) {
  const std::scoped_lock lock(current_guard_);
  current_ = checkpoint;
}

// On the watcher's thread, while the point goes on being computed. The lock is not given back:
// nothing more is written.
std::optional<base::ProgramOutcome> SweepPointSolver::abandon(int signal) {
  current_guard_.lock();
  if (folder_) {
    folder_->abandon();
  }
  return current_ != nullptr && current_->writes_increments()
             ? stop_with_checkpoint(*current_, signal_name(signal), log_)
             : std::nullopt;
}

} // namespace spricka::program
