// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/run_deck.hpp"

#include "base/clock.hpp"
#include "base/diagnostics.hpp"
#include "deck/read_deck.hpp"
#include "run/check_quantities.hpp"
#include "run/run_folder.hpp"
#include "run/solve_run.hpp"

#include <system_error>
#include <thread>

#include <fmt/format.h>

namespace spricka::run {

namespace {

// Cards that are understood but not available: each with its place. False if there is one.
bool all_available(const base::Sources& sources, const model::Model& model, const Log& log) {
  base::Diagnostics list;
  for (const model::Output& output : model.outputs) {
    if (output.format == model::OutputFormat::json) {
      list.error(output.span, "E500", "FORMAT=JSON is not available in this version");
    }
  }
  for (const model::Unavailable& u : model.unavailable) {
    list.error(u.span, "E500", fmt::format("{} is not available in this version", u.what));
  }
  log.diagnostics(sources, list);
  return !list.has_errors();
}

void print_refusal(const base::Sources& sources, const Refusal& refusal, const Log& log) {
  base::Diagnostics list;
  list.error(refusal.span, refusal.exit_code == exit_code::not_converged ? "E520" : "E510",
             refusal.why);
  log.diagnostics(sources, list);
}

// Displacement elements lock where a material hardly changes its volume: at nu = 0.499 stresses are
// still right to a few tenths of a per cent, at 0.4999 displacements are 2 % short.
void warn_of_locking(const model::Model& model, base::Diagnostics& list) {
  for (const model::Property& property : model.properties) {
    const model::Material& material = model.materials[property.material.index()];
    if (property.state == model::State::plane_strain && material.nu > 0.499) {
      list.warning(material.span, "W501",
                   fmt::format("material {}: nu = {:.6g} in plane strain is nearly incompressible; "
                               "the elements lock and results may be several per cent off",
                               material.name, material.nu),
                   "an element form for such materials is not available in this version");
    }
  }
}

int thread_count(const RunOptions& options, const model::Model& model) {
  const int wanted = options.threads >= 0 ? options.threads : model.control.threads;
  return wanted > 0 ? wanted : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

int report_checks(const results::Run& run, const Log& log) {
  int failed = 0;
  for (const results::CheckResult& check : run.checks) {
    if (!check.passed) {
      ++failed;
      log.failed_check(check);
    }
  }
  return failed;
}

void print_summary(const model::Model& model, const results::Run& run,
                   const std::filesystem::path& folder, int failed) {
  for (const results::Increment& increment : run.increments) {
    for (const results::StepResult& step : increment.steps) {
      for (const results::TipResult& tip : step.tips) {
        fmt::print("{:<12} {:<8} a = {:<10.6g} K1 = {:<12.7g} K2 = {:<12.7g} {}\n", step.step,
                   tip.name, tip.a, tip.K1, tip.K2, model.units.stress_intensity_name());
      }
    }
  }
  if (!run.checks.empty()) {
    fmt::print("{} of {} checks passed\n", run.checks.size() - static_cast<std::size_t>(failed),
               run.checks.size());
  }
  fmt::print("{:.2f} s CPU, {:.0f} MiB; results in {}\n", run.cpu,
             static_cast<double>(run.peak_memory) / 1048576.0, folder.string());
}

// What a reader of the results must not miss: said on stderr and kept for listing and report.
void collect_warnings(const base::Diagnostics& reading, results::Run& run, const Log& log) {
  for (const base::Diagnostic& d : reading.all()) {
    if (d.severity == base::Severity::warning) {
      run.warnings.push_back(d.text);
    }
  }
  for (const results::Increment& increment : run.increments) {
    for (const results::StepResult& step : increment.steps) {
      for (const std::string& note : step.notes) {
        if (note.starts_with("warning: ")) {
          run.warnings.push_back(fmt::format("increment {}, step {}: {}", increment.number,
                                             step.step, note.substr(9)));
          log.message(base::Severity::warning, "W502", run.warnings.back());
        }
      }
    }
  }
}

int solve_and_write(const RunOptions& options, const base::Sources& sources,
                    const model::Model& model, const base::Diagnostics& reading) {
  const Log log(options.log_format);
  const double cpu_before = base::cpu_seconds();
  RunFolder folder(options.out);
  base::Diagnostics diagnostics;
  std::optional<Refusal> refusal;
  SolveOptions solve;
  solve.threads = thread_count(options, model);
  solve.progress = log.progress(options.quiet);
  std::optional<results::Run> run = solve_run(model, solve, diagnostics, refusal);
  log.diagnostics(sources, diagnostics);
  if (refusal) {
    print_refusal(sources, *refusal, log);
    return refusal->exit_code;
  }
  if (!run) {
    return exit_code::deck_error;
  }
  collect_warnings(reading, *run, log);
  run->checks = evaluate_checks(model, *run);
  run->cpu += cpu_before;
  folder.write(sources, model, *run);
  const int failed = report_checks(*run, log);
  if (!options.quiet) {
    print_summary(model, *run, options.out, failed);
  }
  return failed > 0 ? exit_code::check_failed : exit_code::done;
}

} // namespace

int run_deck(const RunOptions& given) {
  RunOptions options = given;
  const Log log(options.log_format);
  if (options.out.empty()) {
    options.out = options.deck.filename().replace_extension(".run");
  }
  try {
    base::Sources sources;
    base::Diagnostics diagnostics;
    const std::optional<model::Model> model =
        deck::read_deck(options.deck, {options.defines}, sources, diagnostics);
    if (model) {
      warn_of_locking(*model, diagnostics);
    }
    log.diagnostics(sources, diagnostics);
    if (!model || diagnostics.has_errors()) {
      return exit_code::deck_error;
    }
    if (!all_available(sources, *model, log)) {
      return exit_code::not_solvable;
    }
    if (model->steps.empty()) {
      log.message(base::Severity::error, "E405",
                  "the deck has no $STEP, so there is nothing to solve", options.deck.string());
      return exit_code::deck_error;
    }
    if (options.check_only) {
      fmt::print("{}: no mistakes found\n", options.deck.string());
      return exit_code::done;
    }
    return solve_and_write(options, sources, *model, diagnostics);
  } catch (const std::system_error& trouble) {
    log.message(base::Severity::error, "E530", trouble.what());
    return exit_code::file_trouble;
  }
}

} // namespace spricka::run
