// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/study_deck.hpp"

#include "model/model.hpp"
#include "program/job/standard_streams.hpp"
#include "program/peers/calculix.hpp"
#include "program/study/halves.hpp"
#include "program/study/peer_runs.hpp"
#include "program/study/study_report.hpp"
#include "program/study/variant_runs.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace spricka::program {

namespace {

class StudyRun {
public:
  StudyRun(const StudyOptions& options, VariantRuns& runs)
      : options_(options), runs_(runs),
        plan_(plan_settings(runs.deck(), options.requests, runs.scratch())) {
    study_.notes = plan_.notes;
  }

  base::Outcome run(std::string& summary) {
    const base::Outcome outcome = run_given();
    if (outcome != base::Outcome::done) {
      return outcome;
    }
    run_others();
    run_calculix();
    if (runs_.children().stopped()) {
      return base::Outcome::stopped;
    }
    assess_trials(study_);
    runs_.folder().add_file("study.csv", study_csv(study_));
    runs_.folder().add_file("study.html",
                            study_page(runs_.deck().ready->sources, runs_.model(), study_));
    summary = study_text(study_) + "study.csv and study.html";
    return outcome;
  }

private:
  // The deck itself decides what is asked for.
  base::Outcome run_given() {
    const Setting& given = plan_.settings.front();
    return runs_.run_given(VariantRuns::child_of(given.deck, given.defines),
                           [&](VariantRun found, const results::RunResult& run) -> std::string {
                             study_.answers = collect_answers(runs_.model(), run);
                             study_.trials.push_back(trial_of(given, std::move(found), &run));
                             return study_.answers.empty()
                                        ? "the deck has no answer to judge a mesh by"
                                        : "";
                           });
  }

  void run_others() {
    const std::vector<std::size_t> chosen = affordable();
    std::vector<ChildRun> children;
    for (const std::size_t i : chosen) {
      children.push_back(VariantRuns::child_of(plan_.settings[i].deck, plan_.settings[i].defines));
      children.back().seconds = std::max(4.0 * options_.budget, 60.0);
      children.back().cpu_seconds = options_.budget; // no forecast knows the rounds of a TOL
    }
    study_.trials.resize(1 + chosen.size());
    std::size_t reported = 0;
    runs_.run_others(children, options_.jobs,
                     [&](std::size_t i, VariantRun found, const results::RunResult* run) {
                       const Setting& setting = plan_.settings[chosen[i]];
                       if (!options_.deck.quiet) {
                         to_stderr(fmt::format("{} of {}: {}, {:.2f} s\n", ++reported,
                                               children.size(), setting.name, found.end.cpu));
                       }
                       study_.trials[1 + i] = trial_of(setting, std::move(found), run);
                     });
  }

  void run_calculix() {
    PeerTask task{find_calculix(), runs_.deck().ready, &study_.answers, options_.budget};
    if (task.program.empty()) {
      return;
    }
    for (const Trial& trial : study_.trials) {
      task.seconds -= trial.end.cpu;
    }
    for (Trial& trial : run_peer(runs_.children(), task, study_.trials, study_.notes)) {
      study_.trials.push_back(std::move(trial));
    }
  }

  // Cost grows a little faster than the freedoms, beside what the program takes to start.
  std::vector<std::size_t> affordable() {
    constexpr double start = 0.1; // [s]
    const double own = std::max(study_.trials.front().end.cpu - start, 0.01);
    const double power = runs_.model().mesh.dim + 0.3;
    double spent = study_.trials.front().end.cpu;
    std::vector<std::size_t> chosen;
    std::vector<std::string> left;
    for (std::size_t i = 1; i < plan_.settings.size(); ++i) {
      const double cost = start + own * std::pow(plan_.settings[i].fineness, power);
      if (spent + cost > options_.budget) {
        left.push_back(plan_.settings[i].name);
      } else {
        spent += cost;
        chosen.push_back(i);
      }
    }
    if (!left.empty()) {
      study_.notes.push_back(fmt::format("left out, as --time {:g} would not do: {}",
                                         options_.budget, fmt::join(left, "; ")));
    }
    return chosen;
  }

  [[nodiscard]] Trial trial_of(const Setting& setting, VariantRun found,
                               const results::RunResult* run) const {
    if (run != nullptr) {
      found.readings = read_answers(runs_.model(), study_.answers, *run);
      convert_to_whole_model(found.readings, study_.answers, setting.mirrored);
    }
    return {std::move(found), setting};
  }

  const StudyOptions& options_;
  VariantRuns& runs_;
  StudyPlan plan_;
  Study study_;
};

} // namespace

base::Outcome study_deck(const StudyOptions& options) {
  return run_variants_of(options.deck, ".study", [&](VariantRuns& runs, std::string& summary) {
    return StudyRun(options, runs).run(summary);
  });
}

} // namespace spricka::program
