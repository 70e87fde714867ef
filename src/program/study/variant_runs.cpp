// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/variant_runs.hpp"

#include "base/exit_codes.hpp"
#include "base/input_file.hpp"
#include "model/model.hpp"
#include "program/job/file_failures.hpp"
#include "program/job/interrupt.hpp"
#include "program/job/standard_streams.hpp"
#include "results/store.hpp"
#include "results/store_run.hpp"

#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

namespace fs = std::filesystem;

// The first error among the messages of a run, without its place in a deck that nobody has written.
std::string first_trouble(const ChildEnd& end) {
  if (end.late) {
    return "took too long";
  }
  const std::size_t error = end.messages.find("error");
  if (error != std::string::npos) {
    const std::size_t stop = std::min(end.messages.find('\n', error), end.messages.size());
    return end.messages.substr(error, stop - error);
  }
  return end.signal != 0 ? fmt::format("ended by signal {}", end.signal)
                         : fmt::format("exit code {}", end.exit_code);
}

// Tells `ended` what a run has found, and removes its folder.
void read_end(const ChildRun& variant, const ChildEnd& end, const VariantRuns::Ended& ended) {
  VariantRun found{end, 0, {}, {}};
  std::optional<results::RunResult> run;
  const std::optional<base::Outcome> outcome = base::exit_outcome(end.exit_code);
  const bool has_results =
      outcome && (*outcome == base::Outcome::done || *outcome == base::Outcome::check_failed);
  if (has_results && fs::exists(variant.out / results_name)) {
    const std::string bytes = base::read_file(variant.out / results_name, base::largest_mesh_file);
    run = results::read_run(results::Store::from_bytes(bytes).root());
    for (const results::Increment& increment : run->increments) {
      found.unknowns = std::max(found.unknowns, increment.unknowns);
    }
  } else {
    found.trouble = first_trouble(end);
  }
  std::error_code ignored;
  fs::remove_all(variant.out, ignored);
  ended(std::move(found), run ? &*run : nullptr);
}

// The text of a deck that was read; its places are in the same sources.
StudiedDeck studied_deck(const RunOptions& options, ReadyDeck& ready) {
  base::Diagnostics ignored; // the same mistakes as before: none
  auto text = deck::read_deck_text(options.deck, ready.sources, ignored);
  return {options.deck, options.defines, std::move(text.value()), &ready};
}

} // namespace

base::CsvRow cost_fields(const VariantRun& run) {
  return {{"freedoms", run.unknowns},
          {"cpu", run.end.cpu},
          {"wall", run.end.wall},
          {"memory", run.end.peak_memory},
          {"exit_code", run.end.exit_code}};
}

VariantRuns::VariantRuns(const RunOptions& options, ReadyDeck& ready, const Log& log)
    : log_(log), deck_(studied_deck(options, ready)), place_(resolved_folder(options.out)),
      folder_(options.out), scratch_(place_) {}

void VariantRuns::abandon() {
  children_.stop();
  scratch_.remove();
  folder_.abandon();
}

ChildRun VariantRuns::child_of(const fs::path& deck, const Defines& defines) {
  ChildRun child;
  child.deck = deck;
  child.out = deck.string() + ".run";
  child.defines = defines;
  return child;
}

base::Outcome VariantRuns::run_given(
    const ChildRun& given,
    const std::function<std::string(VariantRun, const results::RunResult&)>& ended) {
  base::Outcome outcome = base::Outcome::stopped;
  run_others({given}, 1, [&](std::size_t, VariantRun found, const results::RunResult* run) {
    std::string lack;
    if (run == nullptr) {
      to_stderr(found.end.messages);
      lack = fmt::format("the deck itself has no results to compare with: {}", found.trouble);
      outcome = base::exit_outcome(found.end.exit_code).value_or(base::Outcome::not_solvable);
      outcome = outcome == base::Outcome::done ? base::Outcome::not_solvable : outcome;
    } else {
      lack = ended(std::move(found), *run);
      outcome = lack.empty() ? base::Outcome::done : base::Outcome::not_solvable;
    }
    if (!lack.empty()) {
      log_.message(base::Severity::error, "E555", lack);
    }
  });
  return outcome;
}

void VariantRuns::run_others(
    const std::vector<ChildRun>& variants, int at_once,
    const std::function<void(std::size_t, VariantRun, const results::RunResult*)>& ended) {
  children_.run_all(variants, at_once, [&](std::size_t i, const ChildEnd& end) {
    read_end(variants[i], end, [&](VariantRun found, const results::RunResult* run) {
      ended(i, std::move(found), run);
    });
  });
}

base::Outcome
run_variants_of(const RunOptions& given, const char* extension,
                const std::function<base::Outcome(VariantRuns&, std::string& summary)>& work) {
  RunOptions options = given;
  const Log log(options.log_format);
  if (options.out.empty()) {
    options.out = options.deck.filename().replace_extension(extension);
  }
  return report_file_failures(log, [&] {
    ReadyDeck ready = read_and_check_deck(options.deck, {.defines = options.defines}, log);
    if (!ready.model) {
      return ready.refusal.kind;
    }
    VariantRuns runs(options, ready, log);
    const InterruptHandler interrupt([&](int signal) {
      runs.abandon();
      return 128 + signal;
    });
    std::string summary;
    const base::Outcome outcome = work(runs, summary);
    if (runs.children()
            .stopped()) { // what was not run says nothing; the interrupt ends the program
      return base::Outcome::stopped;
    }
    if (outcome == base::Outcome::done) {
      runs.folder().commit();
      to_stdout(fmt::format("{} in {}\n", summary, options.out.string()));
    }
    return outcome;
  });
}

} // namespace spricka::program
