// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/variant_runs.hpp"

#include "base/exit_codes.hpp"
#include "base/input_file.hpp"
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

// A run on one thread.
ChildRun child_of(const DeckVariant& variant, double cpu_seconds) {
  return {.deck = variant.deck,
          .out = variant.deck.string() + ".run",
          .defines = variant.defines,
          .seconds = cpu_seconds > 0.0 ? std::max(4.0 * cpu_seconds, 60.0) : 0.0,
          .cpu_seconds = cpu_seconds};
}

// The results in the folder of a run; empty: it has none.
std::optional<results::RunResult> read_results(const fs::path& folder,
                                               const ChildProcessResult& end) {
  const std::optional<base::ProgramOutcome> outcome = base::outcome_of_exit_code(end.exit_code);
  if ((outcome != base::ProgramOutcome::done && outcome != base::ProgramOutcome::check_failed) ||
      !fs::exists(folder / results_name)) {
    return std::nullopt;
  }
  const std::string bytes = base::read_file(folder / results_name, base::largest_mesh_file);
  return results::read_run(results::Store::from_bytes(bytes).root());
}

// The text of a deck that was read; its places are in the same sources.
StudiedDeck studied_deck(const RunOptions& options, CheckedDeck& ready) {
  base::Diagnostics ignored; // the same mistakes as before: none
  auto text = deck::read_deck_card_list(options.deck, ready.sources, ignored);
  return {options.deck, options.defines, std::move(text.value()), &ready};
}

} // namespace

VariantRuns::VariantRuns(const RunOptions& options, CheckedDeck& ready, const Log& log)
    : log_(log), quiet_(options.quiet), deck_(studied_deck(options, ready)),
      place_(canonical_folder(options.out)), folder_(options.out),
      runs_(place_, false, [this](int) { folder_.abandon(); }) {}

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
  return outcome;
}

void VariantRuns::run_other_variants(const std::vector<StudyTrial*>& trials, int at_once,
                                     double cpu_seconds) {
  std::vector<ChildRun> children;
  children.reserve(trials.size());
  for (const StudyTrial* trial : trials) {
    children.push_back(child_of(trial->variant, cpu_seconds));
  }
  std::size_t reported = 0;
  runs_.run_all_children(children, at_once, [&](std::size_t i, const ChildProcessResult& end) {
    read_trial(children[i], end, {}, *trials[i]);
    if (!quiet_) {
      write_to_stderr(fmt::format("{} of {}: {}, {:.2f} s\n", ++reported, trials.size(),
                                  trials[i]->variant.name, end.cpu));
    }
  });
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
    if (outcome == base::ProgramOutcome::done) {
      runs.run_folder().commit();
      write_to_stdout(fmt::format("{} in {}\n", summary, options.out.string()));
    }
    return outcome;
  });
}

} // namespace spricka::program
