// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/job/job.hpp"

#include "analysis/lengths/recorder.hpp"
#include "analysis/lengths/solve_lengths.hpp"
#include "analysis/recover/judge_size.hpp"
#include "analysis/recover/net_errors.hpp"
#include "base/clock.hpp"
#include "base/printable.hpp"
#include "model/model.hpp"
#include "program/checks/check_quantities.hpp"
#include "program/job/failures.hpp"
#include "program/job/geometry_report.hpp"
#include "program/job/progress_line.hpp"
#include "program/job/ready_deck.hpp"
#include "program/job/restart_run.hpp"
#include "program/job/solve_to_tolerance.hpp"
#include "program/job/standard_streams.hpp"
#include "program/profile/profile.hpp"
#include "report/topics/notes.hpp"
#include "report/topics/result_tables.hpp"
#include "results/growth_end.hpp"
#include "results/result_unit.hpp"
#include "sense/end_warnings.hpp"
#include "sense/k_consistency.hpp"
#include "solve/one_thread.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

int report_checks(const model::Model& model, const results::RunResult& run, const Log& log) {
  int failed = 0;
  for (std::size_t i = 0; i < run.checks.size(); ++i) {
    if (!run.checks[i].passed) {
      ++failed;
      log.report_failed_check(run.checks[i],
                              results::check_unit(model.units, model.checks.at(i).kind, run));
    }
  }
  return failed;
}

// What a reader of the results must not miss, behind what meshes with cracks have been warned of.
void add_warnings(const model::Model& model, const results::RunResult& run,
                  base::Diagnostics& list) {
  for (const results::Warning& of_growth : run.warnings) {
    list.warning({}, of_growth.code, of_growth.text);
  }
  for (const report::RepeatedNote& note : report::collect_notes(run)) {
    if (note.first.kind) {
      list.warning({}, std::string(results::warning_code(*note.first.kind)),
                   report::repeated_note_text(note));
    }
  }
  for (std::string& coarse : analysis::describe_coarse_nets(run)) {
    list.warning({}, "W504", std::move(coarse));
  }
  for (std::string& parted : sense::k_consistency_warnings(run)) {
    list.warning({}, "W570", std::move(parted));
  }
  for (sense::RunWarning& warning : sense::find_run_warnings(model, run)) {
    list.warning({}, std::string(warning.code), std::move(warning.text));
  }
  for (const model::ResultCheck& check : model.checks) {
    if (const auto far = far_from_front_warning(check, model.units.length_name, run)) {
      list.warning({}, "W574", fmt::format("{}: {}", check_text(check), *far));
    }
  }
}

// Of reading and of solving, the worst first: for listing and report.
std::vector<results::Warning> all_warnings(const base::Diagnostics& reading,
                                           const base::Diagnostics& solving) {
  base::Diagnostics all;
  for (const base::Diagnostics* list : {&reading, &solving}) {
    for (const base::Diagnostic& d : list->messages()) {
      if (d.severity == base::Severity::warning) {
        all.warning(d.span, d.code, d.text);
      }
    }
  }
  std::vector<results::Warning> warnings;
  for (const base::Diagnostic* d : base::messages_by_severity(all)) {
    warnings.push_back({d->code, d->text});
  }
  return warnings;
}

struct Solved {
  std::optional<results::RunResult> run;
  base::OptionalFailure trouble;
  std::optional<CheckedDeck> finer; ///< what was solved, where it is not the deck as given
  std::string why_not;              ///< why K is not within its tolerance
};

bool is_stopped(const base::OptionalFailure& trouble) {
  return trouble && trouble->kind == base::ProgramOutcome::stopped;
}

// Once, or as often as K needs to come within its tolerance.
Solved solve_deck(const RunOptions& options, const CheckedDeck& deck, RunFolder* folder,
                  archive::Checkpoint* checkpoint, base::Diagnostics& diagnostics) {
  analysis::SolveOptions solve;
  solve.checkpoint = checkpoint;
  solve.threads = solve::reserve_blas_workspace(thread_count(options, *deck.model));
  solve.engine = requested_engine(options, *deck.model);
  solve.recorder = options.recorder.get();
  Solved out;
  bool first = true;
  const auto once = [&](const model::Model& model, base::OptionalFailure& trouble) {
    base::Diagnostics own;
    ProgressLine line(options.log_format, options.quiet);
    std::optional<InterimKTable> so_far;
    if (folder != nullptr) {
      so_far.emplace(model, *folder);
    }
    solve.progress = [&](const analysis::RunProgress& progress) {
      line.report_progress(progress);
      if (so_far && progress.stage.empty()) {
        so_far->set_finished_increments(progress.increment);
      }
    };
    solve.found = [&](const results::CrackLengthResult& increment) {
      if (so_far) {
        so_far->update_increment(increment);
      }
    };
    std::optional<results::RunResult> run = analysis::solve_run(model, solve, own, trouble);
    if (run && solve.engine != base::EquationEngine::automatic) {
      run->log.insert(run->log.begin(),
                      {"CONDENSE", fmt::format("{} for all nets, as {} asks",
                                               base::equation_engine_word(solve.engine),
                                               options.engine.empty() ? "$CONTROL" : "--engine")});
    }
    if (!run && !trouble) {
      trouble = base::OperationFailure{.kind = base::ProgramOutcome::deck_error,
                                       .why = first_error_text(deck.sources, own)};
    }
    // A later round that fails leaves the answer of the one before: what it says of itself is not
    // told.
    if (run || first || is_stopped(trouble)) {
      diagnostics = std::move(own);
      out.trouble = trouble;
    }
    first = false;
    return run;
  };
  if (!has_k_tolerance(*deck.model)) {
    base::OptionalFailure trouble;
    out.run = once(*deck.model, trouble);
    return out;
  }
  const auto read_finer = [&](const std::map<std::string, deck::NetRefinement>& refine) {
    deck::DeckReadOptions finer = deck.options;
    finer.refine = refine;
    const analysis::ScopedProfileInterval span(solve.recorder, "DECK", "meshes made finer");
    return read_deck_silently(options.deck, finer);
  };
  RefinedRun found = solve_to_tolerance(deck, read_finer, once);
  if (is_stopped(out.trouble)) {
    return out; // in a later round: no answer yet
  }
  out.run = std::move(found.run);
  out.finer = std::move(found.deck);
  out.why_not = std::move(found.why_not);
  return out;
}

std::string missed_tolerance(const Solved& solved) {
  return fmt::format("K is not within its tolerance: {}", solved.why_not);
}

// Mistakes of the deck are told already.
void tell_of(const base::OperationFailure& answer, base::Diagnostics& diagnostics) {
  if (answer.kind == base::ProgramOutcome::deck_error) {
    return;
  }
  diagnostics.error(answer.span,
                    answer.kind == base::ProgramOutcome::not_converged ? "E520" : "E510",
                    answer.why, failure_remedy(answer));
}

// How a run ends that has its results.
RunOutcomeWithResults judged(const model::Model& model, const Solved& solved,
                             const results::RunResult& run, const Log& log) {
  const int failed = report_checks(model, run, log);
  RunOutcomeWithResults outcome;
  if (failed > 0) {
    outcome.kind = base::ProgramOutcome::check_failed;
    outcome.error = fmt::format("{} of {} checks failed", failed, run.checks.size());
  } else if (!solved.why_not.empty()) {
    outcome.kind = base::ProgramOutcome::not_converged;
    outcome.error = missed_tolerance(solved);
  }
  if (outcome.kind == base::ProgramOutcome::done && run.growth &&
      results::growth_could_not_continue(*run.growth)) {
    outcome.kind = base::ProgramOutcome::not_solvable;
    outcome.error = run.growth->reason;
    log.report_message(base::Severity::error, "E510", outcome.error);
  }
  return outcome;
}

// What the run has cost goes into its folder beside the results.
std::string write_profile(const RunOptions& options, const base::SourceTexts& sources,
                          const model::Model& model, RunFolder& folder) {
  if (!options.recorder) {
    return {};
  }
  ProfileTexts texts = end_profile(*options.recorder, sources, model, folder.written_bytes());
  folder.add_file(profile_name, texts.csv);
  folder.add_file(trace_name, texts.trace);
  return std::move(texts.table);
}

} // namespace

RunOutcomeWithResults solve_and_write(const RunOptions& options, const CheckedDeck& deck,
                                      RunFolder* folder, archive::Checkpoint* checkpoint,
                                      const Log& log) {
  const double cpu_before = base::cpu_seconds();
  base::Diagnostics diagnostics;
  start_reporting_skipped_state(checkpoint, log);
  Solved solved = solve_deck(options, deck, folder, checkpoint, diagnostics);
  if (is_stopped(solved.trouble)) {
    const std::string by = solved.trouble->why;
    return {stop_with_checkpoint(*checkpoint, by, log).value_or(base::ProgramOutcome::stopped),
            "stopped by " + by,
            {}};
  }
  if (solved.trouble) {
    tell_of(*solved.trouble, diagnostics);
    return report_refusal(deck.sources, diagnostics, solved.trouble->kind, log);
  }
  const CheckedDeck& used = solved.finer ? *solved.finer : deck;
  results::RunResult& run = *solved.run;
  std::optional<analysis::ScopedProfileInterval> checking(std::in_place, options.recorder.get(),
                                                          "CHECKS", "checks, warnings");
  if (!run.increments.empty()) { // of the cracks as they begin
    std::vector<results::Note>& notes = run.increments.front().notes;
    const std::vector<results::Note> flaws = results::make_plain_notes(deck.flaws);
    notes.insert(notes.begin(), flaws.begin(), flaws.end());
  }
  run.tests = find_K_from_growth_tests(*used.model, run);
  // Before the notes are collected: it changes their words.
  analysis::reword_notes_of_broken_ligaments(run);
  add_warnings(*used.model, run, diagnostics);
  if (!solved.why_not.empty()) {
    diagnostics.warning({}, "W506", missed_tolerance(solved));
  }
  log.report_diagnostics(deck.sources, diagnostics);
  run.warnings = all_warnings(deck.diagnostics, diagnostics);
  finish_checkpoint(checkpoint, run);
  run.checks = evaluate_checks(*used.model, run);
  run.cpu += cpu_before;
  checking.reset();
  if (folder != nullptr) {
    const analysis::ScopedProfileInterval span(options.recorder.get(), "OUTPUT",
                                               "tables, pictures, report");
    folder->write_results(deck.sources, *used.model, run, report_imported_geometry(deck.imported));
  }
  RunOutcomeWithResults outcome = judged(*used.model, solved, run, log);
  if (folder != nullptr) {
    outcome.profile = write_profile(options, deck.sources, *used.model, *folder);
  }
  outcome.run = std::move(solved.run);
  return outcome;
}

namespace {

// K1 and K2 with their bars.
std::string tip_text(const results::FrontResult& front, const base::UnitSystem& units) {
  const results::FrontPointResult& tip = front.single_point();
  if (front.two_materials) { // stresses oscillate there: it has a G alone
    const base::OutputUnit unit = base::output_unit(units, base::QuantityKind::energy_release);
    return fmt::format("G = {:<12.7g} {}", unit.from_deck(tip.G), unit.name);
  }
  const base::OutputUnit unit = units.output_stress_intensity();
  const auto bar = [&](std::size_t k) {
    return front.has_error_bar() ? fmt::format(" +- {:<8.2g}", unit.from_deck(tip.bar[k].size()))
                                 : "";
  };
  return fmt::format("K1 = {:<12.7g}{} K2 = {:<12.7g}{} {}{}", unit.from_deck(tip.K1), bar(0),
                     unit.from_deck(tip.K2), bar(1), unit.name, tip.closed ? ", closed" : "");
}

// The range of each mode that is not nothing at the points within the body; empty: there are none.
std::string range_text(const results::FrontResult& front, const base::UnitSystem& units) {
  std::vector<const results::FrontPointResult*> inside;
  for (const results::FrontPointResult& place : front.points) {
    if (!place.at_surface) {
      inside.push_back(&place);
    }
  }
  if (inside.empty()) {
    return {};
  }
  const base::OutputUnit unit = units.output_stress_intensity();
  const auto range = [&](double results::FrontPointResult::*K) {
    const auto [low, high] = std::ranges::minmax_element(
        inside, {}, [&](const results::FrontPointResult* place) { return place->*K; });
    return std::pair(unit.from_deck((*low)->*K), unit.from_deck((*high)->*K));
  };
  const auto [low, high] = range(&results::FrontPointResult::K1);
  std::string text = fmt::format("K1 = {:.7g} .. {:.7g}", low, high);
  int mode = 2;
  for (const auto K : {&results::FrontPointResult::K2, &results::FrontPointResult::K3}) {
    const auto [least, most] = range(K);
    if (std::max(std::abs(least), std::abs(most)) >
        1e-3 * std::max(std::abs(low), std::abs(high))) {
      text += fmt::format(" K{} = {:.6g} .. {:.6g}", mode, least, most);
    }
    ++mode;
  }
  return fmt::format("{} {} along {} points", text, unit.name, front.points.size());
}

// A line for each front: of a growth by a law at KMAX of each station, else of every step.
void print_fronts(const model::Model& model, const results::RunResult& run) {
  const std::string leading = run.growth ? report::leading_step_name(model) : std::string();
  const auto behind_the_end = [&](std::size_t i) { // its cycles are not lived
    return run.growth && i > 0 && i < run.growth->stations.size() &&
           run.growth->stations[i].cycles > run.growth->final_cycles() * (1.0 + 1e-9);
  };
  for (std::size_t i = 0; i < run.increments.size(); ++i) {
    for (const results::LoadStepResult& step : run.increments[i].steps) {
      if (behind_the_end(i)) {
        continue;
      }
      if (run.growth && step.step != leading) {
        continue;
      }
      const std::string before =
          run.growth && i < run.growth->stations.size()
              ? fmt::format("N = {:<11.6g}", results::life_unit(model.units, *run.growth)
                                                 .from_deck(run.growth->stations[i].cycles))
              : fmt::format("{:<12}", step.step);
      for (const results::FrontResult& front : step.fronts) {
        const std::string K =
            front.is_tip() ? tip_text(front, model.units) : range_text(front, model.units);
        if (!K.empty()) {
          write_to_stdout(fmt::format("{} {:<8} a = {:<10.6g} {}\n", before, front.name,
                                      model.units.output_length().from_deck(front.a), K));
        }
      }
    }
  }
}

} // namespace

void print_summary(const CheckedDeck& deck, const results::RunResult& run,
                   const std::filesystem::path& folder) {
  for (const std::string& flaw : deck.flaws) {
    write_to_stdout(flaw + "\n");
  }
  print_fronts(*deck.model, run);
  if (run.growth) {
    // That nothing grows is an answer, but N = 0 alone does not read like it.
    const bool stands = run.growth->ended == "THRESHOLD";
    const base::OutputUnit life = results::life_unit(deck.model->units, *run.growth);
    write_to_stdout(fmt::format("N = {:.7g} {}, ended by {}{}\n",
                                life.from_deck(run.growth->final_cycles()),
                                results::life_unit_words(life.name), run.growth->ended,
                                stands ? ": " + run.growth->reason : ""));
  }
  if (!run.checks.empty()) {
    const auto passed = std::count_if(run.checks.begin(), run.checks.end(),
                                      [](const auto& check) { return check.passed; });
    write_to_stdout(fmt::format("{} of {} checks passed\n", passed, run.checks.size()));
  }
  write_to_stdout(fmt::format("{:.2f} s CPU, {:.0f} MiB; results in {}\n", run.cpu,
                              static_cast<double>(run.peak_memory) / 1048576.0,
                              base::make_printable(folder.string())));
}

} // namespace spricka::program
