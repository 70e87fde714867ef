// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/commands/run_deck.hpp"

#include "analysis/lengths/recorder.hpp"
#include "base/exit_codes.hpp"
#include "model/model.hpp"
#include "program/commands/check_deck.hpp"
#include "program/commands/sweep_deck.hpp"
#include "program/job/failures.hpp"
#include "program/job/interrupt.hpp"
#include "program/job/job.hpp"
#include "program/job/restart_run.hpp"
#include "program/job/standard_streams.hpp"
#include "program/profile/profile.hpp"

#include <mutex>
#include <optional>

#include <fmt/format.h>

namespace spricka::program {

namespace {

// Nothing old is taken for a new result without a word.
void tell_of_earlier(const RunOptions& options, const RunFolder& folder, const Log& log) {
  if (folder.replaces_earlier_run()) {
    log.report_message(
        base::Severity::note, "E467",
        fmt::format("{} still holds the results of an earlier run", options.out.string()));
  }
}

// What was found before a run was stopped stays, apart from results that are whole.
void tell_of_k(const std::optional<std::filesystem::path>& table, const std::string& by,
               const Log& log) {
  if (table) {
    log.report_message(
        base::Severity::note, "E566",
        fmt::format("stopped by {}: K that was found until then is in {}; the next run into "
                    "the same folder removes it",
                    by, table->string()));
  }
}

base::ProgramOutcome run_once(const RunOptions& options, const CheckedDeck& deck, const Log& log) {
  reject_state_in_run_folder(options, *deck.model);
  const CheckpointOrRefusal opened = open_checkpoint(options, deck, {}, log);
  if (opened.refusal) {
    return opened.refusal->kind;
  }
  std::mutex guard; // taken for ever by a signal
  std::optional<RunFolder> folder;
  const InterruptHandler interrupt([&](int signal) {
    guard.lock();
    if (folder) {
      tell_of_k(folder->abandon(true), signal_name(signal), log);
    }
    std::optional<base::ProgramOutcome> kept;
    if (opened.checkpoint && opened.checkpoint->writes_increments()) {
      kept = stop_with_checkpoint(*opened.checkpoint, signal_name(signal), log);
    }
    return kept ? base::exit_code(*kept) : 128 + signal;
  });
  {
    const std::scoped_lock lock(guard);
    folder.emplace(options.out);
  }
  RunOutcomeWithResults outcome;
  try {
    outcome = solve_and_write(options, deck, &*folder, opened.checkpoint.get(), log);
  } catch (...) {
    tell_of_earlier(options, *folder, log);
    throw;
  }
  if (!outcome.run) {
    if (outcome.kind == base::ProgramOutcome::stopped) {
      tell_of_k(folder->retain_interim_k(), "--time", log);
    }
    tell_of_earlier(options, *folder, log);
    return outcome.kind;
  }
  folder->commit();
  if (!options.quiet) {
    print_summary(deck, *outcome.run, options.out);
    write_to_stdout(outcome.profile);
  }
  return outcome.kind;
}

CheckedDeck read_recorded(const RunOptions& options, const Log& log) {
  const analysis::ScopedProfileInterval span(options.recorder.get(), "DECK", "deck and meshes");
  return read_and_check_deck(options.deck, {.defines = options.defines}, log);
}

} // namespace

base::ProgramOutcome run_deck(const RunOptions& given) {
  RunOptions options = given;
  const Log log(options.log_format);
  if (options.out.empty()) {
    options.out = options.deck.filename().replace_extension(".run");
  }
  if (options.profile) {
    options.recorder = begin_profile_of_process(options.since);
  }
  return run_reporting_file_failures(log, [&] {
    const CheckedDeck deck = read_recorded(options, log);
    if (!deck.model) {
      if (options.check_only && !options.json && !options.quiet) {
        write_to_stdout(list_refused_geometry(deck));
      }
      return deck.refusal.kind;
    }
    if (options.check_only) {
      return check_deck(options, deck, log);
    }
    if (reject_restart_without_state(options, *deck.model, log)) {
      return base::ProgramOutcome::usage;
    }
    if (options.sweep_only && deck.model->sweeps.empty()) {
      log.report_message(base::Severity::error, "E552",
                         "the deck has no $SWEEP: spricka run solves it");
      return base::ProgramOutcome::usage;
    }
    return deck.model->sweeps.empty() ? run_once(options, deck, log)
                                      : run_sweep(options, deck, log);
  });
}

} // namespace spricka::program
