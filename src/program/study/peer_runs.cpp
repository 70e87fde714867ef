// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/peer_runs.hpp"

#include "base/input_file.hpp"
#include "mesh/export/write_inp.hpp"
#include "model/model.hpp"
#include "program/checks/check_quantities.hpp"
#include "program/peers/calculix.hpp"
#include "program/peers/inp_of_deck.hpp"
#include "report/drawing/file.hpp"
#include "results/stress_component.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
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

/// Evaluates lines of $CHECK on a run that is nothing but nodal values.
class NodalRun {
public:
  explicit NodalRun(const model::Model& model) : model_(model) {
    results::Increment& increment = run_.increments.emplace_back();
    increment.mesh = model.mesh;
    increment.steps.emplace_back().step = model.steps.front().name;
  }

  void set(base::Vector u) { run_.increments.front().steps.front().u = std::move(u); }

  // Not a number where a line has no value.
  double value(const model::ResultCheck& check) {
    model_.checks = {check};
    const results::CheckResult found = evaluate_checks(model_, run_).front();
    return found.trouble.empty() ? found.found : AnswerReading().value;
  }

private:
  model::Model model_;
  results::RunResult run_;
};

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
  std::vector<AnswerReading> readings(answers.size());
  std::map<std::string, std::vector<std::size_t>> stresses; // by component
  NodalRun run(model);
  run.set(fields.u);
  for (std::size_t a = 0; a < answers.size(); ++a) {
    if (answers[a].group == AnswerGroup::displacement) {
      readings[a].value = run.value(answers[a].check);
    } else if (const std::string component = component_of(answers[a]); !component.empty()) {
      stresses[component].push_back(a);
    }
  }
  for (const auto& [component, asked] : stresses) {
    run.set(as_displacement(fields, component, model.mesh.dim));
    for (const std::size_t a : asked) {
      model::ResultCheck check = answers[a].check;
      check.quantity = "U.X" + check.quantity.substr(check.quantity.rfind('.'));
      readings[a].value = run.value(check);
    }
  }
  return readings;
}

// Whether it is a mesh of the deck as it is: other ways at the tips or in elements are our own.
bool is_plain_mesh(const StudyTrial& trial) {
  const SettingFamily family = trial.setting.family;
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
StudyTrial run_calculix_on(ChildRunner& children, const PeerTask& task, const StudyTrial& own,
                           double seconds) {
  StudyTrial trial;
  trial.setting = own.setting;
  trial.setting.name += ", CalculiX";
  trial.setting.family = SettingFamily::peer;
  trial.unknowns = own.unknowns;
  const CheckedDeck ready = read_deck_silently(own.setting.deck, {.defines = own.setting.defines});
  if (!ready.model) { // the mesher may run out of time in the same deck
    trial.trouble = "the mesh could not be made once more";
    return trial;
  }
  base::Diagnostics refusals;
  const fs::path inp = fs::path(own.setting.deck).replace_extension(".inp");
  report::write_file(inp, adapt_input_for_calculix(abaqus_input_text(*ready.model, refusals),
                                                   ready.model->mesh.dim));
  ChildRun child = make_calculix_run(task.program, inp);
  child.cpu_seconds = std::max(seconds, 1.0);
  children.run_all_children({&child, 1}, 1,
                            [&](std::size_t, const ChildProcessResult& end) { trial.end = end; });
  const std::optional<NodalFields> fields = fields_of(inp, *ready.model);
  if (trial.end.late) {
    trial.trouble = "took too long";
  } else if (trial.end.exit_code != 0 || !fields) {
    trial.trouble = fmt::format("CalculiX gave no result, exit code {}", trial.end.exit_code);
  } else {
    trial.readings = peer_answers(*ready.model, *task.answers, *fields);
  }
  return trial;
}

} // namespace

std::vector<StudyTrial> run_calculix_trials(ChildRunner& children, const PeerTask& task,
                                            const std::vector<StudyTrial>& own,
                                            std::vector<std::string>& notes) {
  const model::Model& model = *task.ready->model;
  if (const std::string refusal = refusal_of(model); !refusal.empty()) {
    notes.push_back(fmt::format("without CalculiX: {}", refusal));
    return {};
  }
  if (model.steps.size() > 1) {
    notes.push_back(fmt::format("CalculiX has the first step alone, {}", model.steps.front().name));
  }
  std::vector<const StudyTrial*> meshes; // coarse to fine
  for (const StudyTrial& trial : own) {
    if (is_plain_mesh(trial)) {
      meshes.push_back(&trial);
    }
  }
  std::ranges::stable_sort(meshes, {},
                           [](const StudyTrial* trial) { return trial->setting.fineness; });
  const double power = model.mesh.dim + 1.0; // of the fineness, that its cost goes with
  double left = task.seconds;
  std::vector<StudyTrial> trials;
  for (const StudyTrial* mesh : meshes) {
    const StudyTrial* const last = trials.empty() ? nullptr : &trials.back();
    const double guess =
        last == nullptr
            ? 0.0
            : last->end.cpu * std::pow(mesh->setting.fineness / last->setting.fineness, power);
    if (children.stopped()) {
      break;
    }
    if (guess > left) {
      notes.push_back(
          fmt::format("CalculiX left out from {} on, as --time would not do", mesh->setting.name));
      break;
    }
    trials.push_back(run_calculix_on(children, task, *mesh, left));
    left -= trials.back().end.cpu;
  }
  return trials;
}

} // namespace spricka::program
