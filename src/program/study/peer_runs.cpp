// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/peer_runs.hpp"

#include "base/input_file.hpp"
#include "mesh/export/write_inp.hpp"
#include "model/model.hpp"
#include "program/peers/calculix.hpp"
#include "program/peers/inp_of_deck.hpp"
#include "program/study/peer_answers.hpp"
#include "report/drawing/file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

namespace fs = std::filesystem;

// Meshes of the deck as it is, coarse to fine: other ways at the tips or in elements are our own.
std::vector<const Trial*> meshes_of(const std::vector<Trial>& own) {
  constexpr std::array plain{SettingFamily::given, SettingFamily::whole, SettingFamily::asked};
  std::vector<const Trial*> found;
  for (const Trial& trial : own) {
    if (!trial.readings.empty() && std::ranges::find(plain, trial.setting.family) != plain.end()) {
      found.push_back(&trial);
    }
  }
  std::ranges::stable_sort(found, {}, [](const Trial* trial) { return trial->setting.fineness; });
  return found;
}

// The first thing of a deck that an input cannot say; empty: it can say all.
std::string refusal_of(const model::Model& model) {
  base::Diagnostics refusals;
  abaqus_input_text(model, refusals);
  return refusals.has_errors() ? refusals.messages().front().text : "";
}

class PeerRuns {
public:
  PeerRuns(ChildRunner& children, const PeerTask& task) : children_(children), task_(task) {}

  Trial run(const Trial& own) {
    Trial trial;
    trial.setting = own.setting;
    trial.setting.name += ", CalculiX";
    trial.setting.family = SettingFamily::peer;
    trial.unknowns = own.unknowns;
    const ReadyDeck ready = read_silently(own.setting.deck, {.defines = own.setting.defines});
    if (!ready.model) { // the mesher may run out of time in the same deck
      trial.trouble = "the mesh could not be made once more";
      return trial;
    }
    base::Diagnostics refusals;
    const fs::path inp = fs::path(own.setting.deck).replace_extension(".inp");
    report::write_file(inp, adapt_input_for_calculix(abaqus_input_text(*ready.model, refusals),
                                                     ready.model->mesh.dim));
    ChildRun child = calculix_run(task_.program, inp);
    child.cpu_seconds = std::max(task_.seconds - spent_, 1.0);
    children_.run_all({&child, 1}, 1, [&](std::size_t, const ChildEnd& end) { trial.end = end; });
    spent_ += trial.end.cpu;
    const std::optional<NodalFields> fields = fields_of(inp, *ready.model);
    if (trial.end.late) {
      trial.trouble = "took too long";
    } else if (trial.end.exit_code != 0 || !fields) {
      trial.trouble = fmt::format("CalculiX gave no result, exit code {}", trial.end.exit_code);
    } else {
      trial.readings = peer_answers(*ready.model, *task_.answers, *fields);
    }
    return trial;
  }

  [[nodiscard]] double left() const { return task_.seconds - spent_; }

private:
  static std::optional<NodalFields> fields_of(const fs::path& inp, const model::Model& model) {
    const fs::path frd = fs::path(inp).replace_extension(".frd");
    if (!fs::exists(frd)) {
      return std::nullopt;
    }
    return read_frd(base::read_file(frd, base::largest_mesh_file),
                    mesh::inp_node_numbers(model.mesh), model.mesh.dim);
  }

  ChildRunner& children_;
  const PeerTask& task_;
  double spent_ = 0.0;
};

} // namespace

std::vector<Trial> run_peer(ChildRunner& children, const PeerTask& task,
                            const std::vector<Trial>& own, std::vector<std::string>& notes) {
  if (const std::string refusal = refusal_of(*task.ready->model); !refusal.empty()) {
    notes.push_back(fmt::format("without CalculiX: {}", refusal));
    return {};
  }
  if (task.ready->model->steps.size() > 1) {
    notes.push_back(fmt::format("CalculiX has the first step alone, {}",
                                task.ready->model->steps.front().name));
  }
  const double power =
      task.ready->model->mesh.dim + 1.0; // of the fineness, that its cost goes with
  std::vector<Trial> trials;
  PeerRuns runs(children, task);
  for (const Trial* mesh : meshes_of(own)) {
    const double fineness = mesh->setting.fineness;
    const double guess =
        trials.empty()
            ? 0.0
            : trials.back().end.cpu * std::pow(fineness / trials.back().setting.fineness, power);
    if (children.stopped()) {
      break;
    }
    if (guess > runs.left()) {
      notes.push_back(
          fmt::format("CalculiX left out from {} on, as --time would not do", mesh->setting.name));
      break;
    }
    trials.push_back(runs.run(*mesh));
  }
  return trials;
}

} // namespace spricka::program
