// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/variant_runs.hpp"

#include "archive/deck_digest.hpp"
#include "base/exit_codes.hpp"
#include "model/model.hpp"
#include "program/job/failures.hpp"
#include "program/job/standard_streams.hpp"
#include "program/trials/deck_outcome.hpp"
#include "results/store.hpp"
#include "results/store_run.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace spricka::program {

namespace {

namespace fs = std::filesystem;

// The first error among the messages of a run, without its place in a deck that nobody has written.
std::string first_trouble(const ChildProcessResult& end) {
  const std::string line = first_error_line(end.messages);
  const std::size_t error = line.find("error");
  return end.late                     ? "took too long"
         : error != std::string::npos ? line.substr(error)
         : end.signal != 0            ? fmt::format("ended by signal {}", end.signal)
                                      : fmt::format("exit code {}", end.exit_code);
}

// The results in the folder of a run; empty: it has none.
std::optional<results::RunResult> read_results(const fs::path& folder,
                                               const ChildProcessResult& end) {
  const std::optional<base::ProgramOutcome> outcome = base::outcome_of_exit_code(end.exit_code);
  if ((outcome != base::ProgramOutcome::done && outcome != base::ProgramOutcome::check_failed) ||
      !fs::exists(folder / results_name)) {
    return std::nullopt;
  }
  return results::read_run(results::Store::from_file(folder / results_name).root());
}

// The text of a deck that was read; its places are in the same sources.
StudiedDeck studied_deck(const RunOptions& options, CheckedDeck& ready) {
  base::Diagnostics ignored; // the same mistakes as before: none
  auto text = deck::read_deck_card_list(options.deck, ready.sources, ignored);
  return {options.deck, options.defines, std::move(text.value()), &ready};
}

// What all variants depend on: the deck with its includes, imported files and -D.
SharedRunOptions sharing_of(const RunOptions& options, const CheckedDeck& ready,
                            const fs::path& place) {
  SharedRunOptions sharing{.task = options.array, .collect = options.collect};
  if (sharing.is_shared()) {
    sharing.folder = place.string() + ".runs";
    sharing.digest = archive::compute_deck_digest(ready.sources, *ready.model, {});
  }
  return sharing;
}

} // namespace

VariantRuns::VariantRuns(const RunOptions& options, CheckedDeck& ready, const Log& log)
    : log_(log), quiet_(options.quiet), engine_(options.engine), task_(options.array.has_value()),
      deck_(studied_deck(options, ready)), place_(canonical_folder(options.out)),
      folder_(task_ ? nullptr : std::make_unique<RunFolder>(options.out)),
      runs_(
          place_, false,
          [this](int) {
            if (folder_) {
              folder_->abandon();
            }
          },
          sharing_of(options, ready, place_)) {}

// A run on one thread.
ChildRun VariantRuns::child_of(const DeckVariant& variant, double cpu_seconds) const {
  return {.deck = variant.deck,
          .out = runs_.run_folder(variant.deck.stem().string()),
          .defines = variant.defines,
          .engine = engine_,
          .seconds = cpu_seconds > 0.0 ? std::max(4.0 * cpu_seconds, 60.0) : 0.0,
          .cpu_seconds = cpu_seconds};
}

void VariantRuns::tell(const DeckVariant& variant, const ChildProcessResult& end,
                       std::size_t count) {
  ++reported_;
  if (!quiet_) {
    write_to_stderr(
        fmt::format("{} of {}: {}, {:.2f} s\n", reported_, count, variant.name, end.cpu));
  }
}

bool VariantRuns::read_trial(const ChildRun& child, const ChildProcessResult& end,
                             const AnswerChoice& choose, StudyTrial& trial) {
  trial.end = end;
  const std::optional<results::RunResult> run = read_results(child.out, end);
  if (!run) {
    trial.trouble = first_trouble(end);
    return false;
  }
  if (choose) {
    answers_ = choose(model(), *run);
  }
  for (const results::CrackLengthResult& increment : run->increments) {
    trial.unknowns = std::max(trial.unknowns, increment.unknowns);
  }
  trial.asked = checks_asked_of_variant(trial.variant, answers_);
  trial.readings = trial.variant.section
                       ? read_answers(read_deck_silently(trial.variant.deck, {}).model.value(),
                                      trial.asked, *run)
                       : read_answers(model(), trial.asked, *run);
  return true;
}

base::ProgramOutcome VariantRuns::run_original_deck(StudyTrial& given, const AnswerChoice& choose) {
  base::ProgramOutcome outcome = base::ProgramOutcome::stopped;
  const ChildRun child = child_of(given.variant, 0.0);
  ++asked_for_;
  runs_.run_all_children({&child, 1}, 1, [&](std::size_t, const ChildProcessResult& end) {
    const bool solved = read_trial(child, end, choose, given);
    outcome = solved
                  ? base::ProgramOutcome::done
                  : base::outcome_of_exit_code(end.exit_code).value_or(base::ProgramOutcome::done);
    if (!answers_.empty()) {
      return;
    }
    outcome = outcome == base::ProgramOutcome::done ? base::ProgramOutcome::not_solvable : outcome;
    write_to_stderr(solved ? "" : end.messages);
    log_.report_message(
        base::Severity::error, "E555",
        solved ? "the deck has no answer to compare"
               : fmt::format("the deck itself has no results to compare with: {}", given.trouble));
  });
  return runs_.missing_runs().empty() ? outcome : report_missing_runs();
}

base::ProgramOutcome VariantRuns::report_missing_runs() const {
  if (runs_.missing_runs().empty()) {
    return base::ProgramOutcome::done;
  }
  fs::path kept = place_;
  kept += ".runs";
  log_.report_message(base::Severity::error, "E553",
                      missing_runs_text(runs_.missing_runs(), asked_for_, "run", kept));
  return base::ProgramOutcome::stopped;
}

void VariantRuns::run_other_variants(const std::vector<StudyTrial*>& trials, int at_once,
                                     double cpu_seconds) {
  asked_for_ += trials.size();
  std::vector<ChildRun> children;
  children.reserve(trials.size());
  for (const StudyTrial* trial : trials) {
    children.push_back(child_of(trial->variant, cpu_seconds));
  }
  reported_ = 0;
  runs_.run_all_children(children, at_once, [&](std::size_t i, const ChildProcessResult& end) {
    read_trial(children[i], end, {}, *trials[i]);
    tell(trials[i]->variant, end, trials.size());
  });
  for (StudyTrial* const trial : trials) {
    if (std::ranges::find(runs_.missing_runs(), trial->variant.deck.stem().string()) !=
        runs_.missing_runs().end()) {
      trial->trouble = "no task has finished it yet";
    }
  }
}

base::ProgramOutcome VariantRuns::run_share(const std::vector<StudyTrial*>& trials, int at_once,
                                            double cpu_seconds) {
  std::vector<ChildRun> children;
  children.reserve(trials.size());
  for (const StudyTrial* trial : trials) {
    children.push_back(child_of(trial->variant, cpu_seconds));
  }
  runs_.run_all_children(children, at_once, [&](std::size_t i, const ChildProcessResult& end) {
    tell(trials[i]->variant, end, trials.size());
  });
  if (!runs_.missing_runs().empty()) {
    log_.report_message(base::Severity::note, "E554",
                        fmt::format("not finished: {}", fmt::join(runs_.missing_runs(), ", ")));
    return base::ProgramOutcome::stopped;
  }
  return base::ProgramOutcome::done;
}

base::ProgramOutcome run_deck_variants(
    const RunOptions& given, const char* extension,
    const std::function<base::ProgramOutcome(VariantRuns&, std::string& summary)>& work) {
  RunOptions options = given;
  const Log log(options.log_format);
  if (options.out.empty()) {
    options.out = options.deck.filename().replace_extension(extension);
  }
  return run_reporting_file_failures(log, [&] {
    CheckedDeck ready = read_and_check_deck(options.deck, {.defines = options.defines}, log);
    if (!ready.model) {
      return ready.refusal.kind;
    }
    VariantRuns runs(options, ready, log);
    std::string summary;
    const base::ProgramOutcome outcome = work(runs, summary);
    if (runs.process_runs().stopped()) { // the interrupt ends the program
      return base::ProgramOutcome::stopped;
    }
    if (outcome != base::ProgramOutcome::done || runs.is_task()) {
      return outcome;
    }
    runs.run_folder().commit();
    write_to_stdout(fmt::format("{} in {}\n", summary, options.out.string()));
    return runs.report_missing_runs();
  });
}

} // namespace spricka::program
