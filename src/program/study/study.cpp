// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/study.hpp"

#include "base/input_file.hpp"
#include "mesh/export/write_inp.hpp"
#include "model/model.hpp"
#include "program/peers/calculix.hpp"
#include "program/peers/inp_of_deck.hpp"
#include "report/drawing/file.hpp"
#include "results/stress_component.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

namespace fs = std::filesystem;

// "S.YY.MAX" -> "YY"; empty: no stress.
std::string component_of(const AnswerRequest& answer) {
  const std::string_view quantity = answer.check.quantity;
  const std::size_t end = quantity.rfind('.');
  return answer.group == AnswerGroup::stress && end > 1 ? std::string(quantity.substr(2, end - 2))
                                                        : std::string();
}

// A component of the stress in the place of the displacement in X. [dim * node]
base::Vector as_displacement(const NodalFields& fields, const std::string& component, int dim) {
  base::Vector u = base::Vector::Zero(fields.u.size());
  for (std::size_t n = 0; n < fields.stress.size(); ++n) {
    u[static_cast<Eigen::Index>(n) * dim] =
        results::stress_component(fields.stress[n], component).value_or(AnswerReading().value);
  }
  return u;
}

// What displacements and stresses at the nodes of a deck's first step say of its answers; between
// nodes by the shape functions. What is of another step, or neither, is no number. [answer]
std::vector<AnswerReading> peer_answers(const model::Model& model,
                                        const std::vector<AnswerRequest>& answers,
                                        const NodalFields& fields) {
  results::RunResult run; // of nodal values alone
  run.increments.emplace_back().mesh = model.mesh;
  results::LoadStepResult& step = run.increments.front().steps.emplace_back();
  step.step = model.steps.front().name;
  std::vector<AnswerReading> readings(answers.size());
  for (std::size_t a = 0; a < answers.size(); ++a) {
    model::ResultCheck check = answers[a].check;
    const std::string component = component_of(answers[a]);
    if (answers[a].group == AnswerGroup::displacement) {
      step.u = fields.u;
    } else if (!component.empty()) {
      step.u = as_displacement(fields, component, model.mesh.dim);
      check.quantity = "U.X" + check.quantity.substr(check.quantity.rfind('.'));
    } else {
      continue;
    }
    readings[a].value = find_check_value(model, check, run);
  }
  return readings;
}

// Whether it is a mesh of the deck as it is: other ways at the tips or in elements are our own.
bool is_plain_mesh(const StudyTrial& trial) {
  const SettingFamily family = trial.variant.family;
  return !trial.readings.empty() &&
         (family == SettingFamily::given || family == SettingFamily::whole ||
          family == SettingFamily::asked);
}

// The first thing of a deck that an input cannot say; empty: it can say all.
std::string refusal_of(const model::Model& model) {
  base::Diagnostics refusals;
  abaqus_input_text(model, refusals);
  return refusals.has_errors() ? refusals.messages().front().text : "";
}

std::optional<NodalFields> fields_of(const fs::path& inp, const model::Model& model) {
  const fs::path frd = fs::path(inp).replace_extension(".frd");
  return fs::exists(frd) ? read_calculix_results(base::read_file(frd, base::largest_mesh_file),
                                                 mesh::inp_node_numbers(model.mesh), model.mesh.dim)
                         : std::nullopt;
}

// The mesh of a trial once more, with so much CPU time [s].
StudyTrial run_calculix_on(VariantRuns& runs, const fs::path& program, const StudyTrial& own,
                           double seconds) {
  StudyTrial trial;
  trial.variant = own.variant;
  trial.variant.name += ", CalculiX";
  trial.variant.family = SettingFamily::peer;
  trial.unknowns = own.unknowns;
  const CheckedDeck ready = read_deck_silently(own.variant.deck, {.defines = own.variant.defines});
  if (!ready.model) { // the mesher may run out of time in the same deck
    trial.trouble = "the mesh could not be made once more";
    return trial;
  }
  base::Diagnostics refusals;
  const fs::path inp = fs::path(own.variant.deck).replace_extension(".inp");
  report::write_file(inp, adapt_input_for_calculix(abaqus_input_text(*ready.model, refusals),
                                                   ready.model->mesh.dim));
  ChildRun child = make_calculix_run(program, inp);
  child.cpu_seconds = std::max(seconds, 1.0);
  runs.process_runs().run_all_children(
      {&child, 1}, 1, [&](std::size_t, const ChildProcessResult& end) { trial.end = end; });
  const std::optional<NodalFields> fields = fields_of(inp, *ready.model);
  if (trial.end.late) {
    trial.trouble = "took too long";
  } else if (trial.end.exit_code != 0 || !fields) {
    trial.trouble = fmt::format("CalculiX gave no result, exit code {}", trial.end.exit_code);
  } else {
    trial.readings = peer_answers(*ready.model, runs.requested_answers(), *fields);
  }
  return trial;
}

// The meshes of the deck as it is once more, by CalculiX, coarse to fine, as long as there is time;
// inputs and results are left beside their decks. What it cannot be asked, or has no time for, goes
// to the notes.
void run_calculix(VariantRuns& runs, double budget, Study& study) {
  const fs::path program = find_calculix();
  if (program.empty()) {
    return;
  }
  const model::Model& model = runs.model();
  if (const std::string refusal = refusal_of(model); !refusal.empty()) {
    study.notes.push_back(fmt::format("without CalculiX: {}", refusal));
    return;
  }
  if (model.steps.size() > 1) {
    study.notes.push_back(
        fmt::format("CalculiX has the first step alone, {}", model.steps.front().name));
  }
  double left = budget;
  std::vector<const StudyTrial*> meshes; // coarse to fine
  for (const StudyTrial& trial : study.trials) {
    left -= trial.end.cpu;
    if (is_plain_mesh(trial)) {
      meshes.push_back(&trial);
    }
  }
  std::ranges::stable_sort(meshes, {},
                           [](const StudyTrial* trial) { return trial->variant.fineness; });
  const double power = model.mesh.dim + 1.0; // of the fineness, that its cost goes with
  std::vector<StudyTrial> trials;
  for (const StudyTrial* mesh : meshes) {
    const StudyTrial* const last = trials.empty() ? nullptr : &trials.back();
    const double guess =
        last == nullptr
            ? 0.0
            : last->end.cpu * std::pow(mesh->variant.fineness / last->variant.fineness, power);
    if (runs.process_runs().stopped()) {
      break;
    }
    if (guess > left) {
      study.notes.push_back(
          fmt::format("CalculiX left out from {} on, as --time would not do", mesh->variant.name));
      break;
    }
    trials.push_back(run_calculix_on(runs, program, *mesh, left));
    left -= trials.back().end.cpu;
  }
  std::ranges::move(trials, std::back_inserter(study.trials));
}

// Settings for which there is time become trials behind that of the deck itself. Cost grows a
// little faster than the freedoms, beside what the program takes to start.
void add_affordable_trials(const std::vector<DeckVariant>& settings, double budget, int dim,
                           Study& study) {
  constexpr double start = 0.1; // [s]
  double spent = study.trials.front().end.cpu;
  const double own = std::max(spent - start, 0.01);
  std::vector<std::string> left;
  for (const DeckVariant& setting : std::span(settings).subspan(1)) {
    const double cost = start + own * std::pow(setting.fineness, dim + 0.3);
    if (spent + cost > budget) {
      left.push_back(setting.name);
    } else {
      spent += cost;
      study.trials.push_back({.variant = setting});
    }
  }
  if (!left.empty()) {
    study.notes.push_back(
        fmt::format("left out, as --time {:g} would not do: {}", budget, fmt::join(left, "; ")));
  }
}

// All of them: what one task would find that time is left for, another does not know.
void add_all_trials(const std::vector<DeckVariant>& settings, Study& study) {
  for (const DeckVariant& setting : std::span(settings).subspan(1)) {
    study.trials.push_back({.variant = setting});
  }
}

std::vector<StudyTrial*> trials_from(Study& study, std::size_t first) {
  std::vector<StudyTrial*> trials;
  for (StudyTrial& trial : std::span(study.trials).subspan(first)) {
    trials.push_back(&trial);
  }
  return trials;
}

base::ProgramOutcome run_study(const StudyOptions& options, VariantRuns& runs,
                               std::string& summary) {
  Study study;
  const std::vector<DeckVariant> settings =
      plan_study_settings(runs.deck(), options.requests, runs.scratch_folder(), study.notes);
  study.trials.push_back({.variant = settings.front()});
  if (runs.is_task()) {
    add_all_trials(settings, study);
    return runs.run_share(trials_from(study, 0), options.jobs, options.budget);
  }
  const base::ProgramOutcome outcome =
      runs.run_original_deck(study.trials.front(), collect_answer_requests);
  if (outcome != base::ProgramOutcome::done) {
    return outcome;
  }
  study.answers = runs.requested_answers();
  const bool collects = options.deck.collect;
  if (collects) {
    add_all_trials(settings, study);
  } else {
    add_affordable_trials(settings, options.budget, runs.model().mesh.dim, study);
  }
  // No forecast knows the rounds of a TOL: each has a limit of its own.
  runs.run_other_variants(trials_from(study, 1), options.jobs, options.budget);
  if (collects) {
    study.notes.push_back("without CalculiX: the tasks of an array do not run it");
  } else {
    run_calculix(runs, options.budget, study);
  }
  if (runs.process_runs().stopped()) {
    return base::ProgramOutcome::stopped;
  }
  assess_trials(study);
  runs.run_folder().add_file("study.csv", study_csv(study));
  runs.run_folder().add_file("study.html",
                             study_page(runs.deck().ready->sources, runs.model(), study));
  summary = study_text(study) + "study.csv and study.html";
  return outcome;
}

} // namespace

base::ProgramOutcome study_deck(const StudyOptions& options) {
  return run_deck_variants(options.deck, ".study", [&](VariantRuns& runs, std::string& summary) {
    return run_study(options, runs, summary);
  });
}

} // namespace spricka::program
