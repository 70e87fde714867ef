// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/study_deck.hpp"

#include "archive/safe_file.hpp"
#include "base/exit_codes.hpp"
#include "model/model.hpp"
#include "program/job/interrupt.hpp"
#include "program/job/run_folder.hpp"
#include "program/job/standard_streams.hpp"
#include "program/peers/calculix.hpp"
#include "program/study/halves.hpp"
#include "program/study/judge.hpp"
#include "program/study/peer_runs.hpp"
#include "program/study/study_report.hpp"
#include "program/study/variant_runs.hpp"

#include <algorithm>
#include <cmath>
#include <system_error>

#include <fmt/format.h>

namespace spricka::program {

namespace {

namespace fs = std::filesystem;

class StudyRun {
public:
  StudyRun(const StudyOptions& options, const Log& log) : options_(options), log_(log) {}

  base::Outcome run() {
    ready_ = read_and_check_deck(options_.deck.deck, {.defines = options_.deck.defines}, log_);
    if (!ready_.model) {
      return ready_.refusal.kind;
    }
    base::Diagnostics ignored; // the same mistakes as before: none
    const auto text = deck::read_deck_text(options_.deck.deck, ready_.sources, ignored);
    const StudiedDeck deck{options_.deck.deck, options_.deck.defines, text.value(), &ready_};
    RunFolder folder(options_.deck.out);
    const ScratchFolder scratch(options_.deck.out);
    const InterruptHandler interrupt([&](int signal) {
      children_.stop();
      scratch.remove();
      folder.abandon();
      return 128 + signal;
    });
    const StudyPlan plan = plan_settings(deck, options_.requests, scratch.path());
    study_.notes = plan.notes;
    if (const base::Outcome outcome = run_given(plan, scratch.path());
        outcome != base::Outcome::done) {
      return outcome;
    }
    run_others(plan, scratch.path());
    run_calculix();
    study_.verdict = assess_trials(study_.answers, study_.trials);
    folder.add_file("study.csv", study_csv(study_));
    folder.add_file("study.html", study_page(ready_.sources, *ready_.model, study_));
    folder.commit();
    to_stdout(study_text(study_));
    to_stdout(fmt::format("study.csv and study.html in {}\n", options_.deck.out.string()));
    return base::Outcome::done;
  }

private:
  [[nodiscard]] static ChildRun child_of(const Setting& setting, const fs::path& scratch) {
    ChildRun child;
    child.deck = setting.deck;
    child.out = scratch / setting.deck.stem();
    child.defines = setting.defines;
    child.threads = 1;
    return child;
  }

  // The deck itself decides what is asked for.
  base::Outcome run_given(const StudyPlan& plan, const fs::path& scratch) {
    VariantOutcome found = run_variant(children_, child_of(plan.settings.front(), scratch));
    if (!found.run) {
      to_stderr(found.end.messages);
      log_.message(
          base::Severity::error, "E555",
          fmt::format("the deck itself has no results to compare with: {}", found.trouble));
      return base::exit_outcome(found.end.exit_code).value_or(base::Outcome::not_solvable);
    }
    study_.answers = collect_answers(*ready_.model, *found.run);
    if (study_.answers.empty()) {
      log_.message(base::Severity::error, "E555", "the deck has no answer to judge a mesh by");
      return base::Outcome::not_solvable;
    }
    add(plan.settings.front(), found);
    return base::Outcome::done;
  }

  void run_others(const StudyPlan& plan, const fs::path& scratch) {
    const std::vector<std::size_t> chosen = affordable(plan);
    std::vector<ChildRun> children;
    for (const std::size_t i : chosen) {
      children.push_back(child_of(plan.settings[i], scratch));
      children.back().seconds = std::max(4.0 * options_.budget, 60.0);
      children.back().cpu_seconds = options_.budget; // no forecast knows the rounds of a TOL
    }
    run_variants(children_, children, options_.jobs, [&](std::size_t i, const VariantOutcome& end) {
      if (!options_.deck.quiet) {
        to_stderr(fmt::format("{} of {}: {}, {:.2f} s\n", ++reported_, children.size(),
                              plan.settings[chosen[i]].name, end.end.cpu));
      }
      trials_.emplace_back(chosen[i], trial_of(plan.settings[chosen[i]], end));
    });
    std::ranges::sort(trials_, {}, [](const auto& entry) { return entry.first; });
    for (auto& entry : trials_) {
      study_.trials.push_back(std::move(entry.second));
    }
  }

  void run_calculix() {
    PeerTask task{find_calculix(), &ready_, &study_.answers, options_.budget};
    if (task.program.empty()) {
      return;
    }
    for (const Trial& trial : study_.trials) {
      task.seconds -= trial.end.cpu;
    }
    for (Trial& trial : run_peer(children_, task, study_.trials, study_.notes)) {
      study_.trials.push_back(std::move(trial));
    }
  }

  // Cost grows a little faster than the freedoms, beside what the program takes to start.
  std::vector<std::size_t> affordable(const StudyPlan& plan) {
    constexpr double start = 0.1; // [s]
    const double own = std::max(study_.trials.front().end.cpu - start, 0.01);
    const double power = ready_.model->mesh.dim + 0.3;
    double spent = study_.trials.front().end.cpu;
    std::vector<std::size_t> chosen;
    std::vector<std::string> left;
    for (std::size_t i = 1; i < plan.settings.size(); ++i) {
      const double cost = start + own * std::pow(plan.settings[i].fineness, power);
      if (spent + cost > options_.budget) {
        left.push_back(plan.settings[i].name);
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

  [[nodiscard]] Trial trial_of(const Setting& setting, const VariantOutcome& end) const {
    Trial trial{setting, end.end, end.unknowns, {}, end.trouble};
    if (end.run) {
      trial.readings = read_answers(*ready_.model, study_.answers, *end.run);
      convert_to_whole_model(trial.readings, study_.answers, setting.mirrored);
    }
    return trial;
  }

  void add(const Setting& setting, const VariantOutcome& end) {
    study_.trials.push_back(trial_of(setting, end));
  }

  const StudyOptions& options_;
  const Log& log_;
  ReadyDeck ready_;
  ChildRunner children_;
  Study study_;
  std::vector<std::pair<std::size_t, Trial>> trials_; ///< by setting, as they end
  std::size_t reported_ = 0;
};

} // namespace

base::Outcome study_deck(const StudyOptions& given) {
  StudyOptions options = given;
  const Log log(options.deck.log_format);
  if (options.deck.out.empty()) {
    options.deck.out = options.deck.deck.filename().replace_extension(".study");
  }
  try {
    return StudyRun(options, log).run();
  } catch (const archive::FileFailure& trouble) {
    log.message(base::Severity::error, trouble.code(), trouble.what());
    return base::Outcome::file_trouble;
  } catch (const std::system_error& trouble) {
    log.message(base::Severity::error, "E530", trouble.what());
    return base::Outcome::file_trouble;
  }
}

} // namespace spricka::program
