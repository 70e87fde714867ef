// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/study_deck.hpp"

#include "model/model.hpp"
#include "program/peers/calculix.hpp"
#include "program/study/peer_runs.hpp"
#include "program/study/study_report.hpp"
#include "program/study/variant_runs.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace spricka::program {

namespace {

// Settings for which there is time, without the deck itself, which took `spent`. Cost grows a
// little faster than the freedoms, beside what the program takes to start.
std::vector<const StudySetting*> affordable_settings(const StudyPlan& plan, double spent,
                                                     double budget, int dim,
                                                     std::vector<std::string>& notes) {
  constexpr double start = 0.1; // [s]
  const double own = std::max(spent - start, 0.01);
  std::vector<const StudySetting*> chosen;
  std::vector<std::string> left;
  for (std::size_t i = 1; i < plan.settings.size(); ++i) {
    const StudySetting& setting = plan.settings[i];
    const double cost = start + own * std::pow(setting.fineness, dim + 0.3);
    if (spent + cost > budget) {
      left.push_back(setting.name);
    } else {
      spent += cost;
      chosen.push_back(&setting);
    }
  }
  if (!left.empty()) {
    notes.push_back(
        fmt::format("left out, as --time {:g} would not do: {}", budget, fmt::join(left, "; ")));
  }
  return chosen;
}

// In what is left of the time.
void run_calculix(VariantRuns& runs, double budget, Study& study) {
  PeerTask task{find_calculix(), runs.deck().ready, &study.answers, budget};
  if (task.program.empty()) {
    return;
  }
  for (const StudyTrial& trial : study.trials) {
    task.seconds -= trial.end.cpu;
  }
  std::ranges::move(run_calculix_trials(runs.children(), task, study.trials, study.notes),
                    std::back_inserter(study.trials));
}

base::Outcome run_study(const StudyOptions& options, VariantRuns& runs, std::string& summary) {
  const StudyPlan plan = plan_study_settings(runs.deck(), options.requests, runs.scratch());
  Study study;
  study.notes = plan.notes;
  StudyTrial& given = study.trials.emplace_back();
  given.setting = plan.settings.front();
  const base::Outcome outcome = runs.run_original_deck(given.setting, given, collect_answers);
  if (outcome != base::Outcome::done) {
    return outcome;
  }
  study.answers = runs.answers();
  const std::vector<const StudySetting*> chosen =
      affordable_settings(plan, given.end.cpu, options.budget, runs.model().mesh.dim, study.notes);
  // No forecast knows the rounds of a TOL: each has a limit of its own.
  std::vector<VariantRun> found =
      runs.run_other_variants({chosen.begin(), chosen.end()}, options.jobs, options.budget);
  for (std::size_t i = 0; i < found.size(); ++i) {
    study.trials.push_back({std::move(found[i]), *chosen[i]});
  }
  run_calculix(runs, options.budget, study);
  if (runs.children().stopped()) {
    return base::Outcome::stopped;
  }
  assess_trials(study);
  runs.folder().add_file("study.csv", study_csv(study));
  runs.folder().add_file("study.html", study_page(runs.deck().ready->sources, runs.model(), study));
  summary = study_text(study) + "study.csv and study.html";
  return outcome;
}

} // namespace

base::Outcome study_deck(const StudyOptions& options) {
  return run_variants_of(options.deck, ".study", [&](VariantRuns& runs, std::string& summary) {
    return run_study(options, runs, summary);
  });
}

} // namespace spricka::program
