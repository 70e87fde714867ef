// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/adjoint/sensitivities.hpp"
#include "analysis/recover/recover_step.hpp"
#include "program/job/job.hpp"
#include "tests/unit/support/run_text.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>

namespace spricka::test {

/// A deck given as text, its steps walked one by one: what the processors leave is open to look at.
struct SolvedScene {
  /// Changes to the model as it was read, or to the scene as it was made.
  struct Changes {
    std::function<void(model::Model&)> model;
    std::function<void(analysis::Scene&, const model::Model&)> scene;
  };

  program::ReadyDeck deck;
  std::optional<analysis::Scene> scene;
  analysis::CondensationCache cache;
  std::vector<analysis::BodyNet> bodies;
  std::unique_ptr<analysis::StepSolver> solver;
  std::unique_ptr<analysis::Adjoints> adjoints;
  std::unique_ptr<analysis::Sensitivities> sensitivities;

  explicit SolvedScene(const std::string& text, const Changes& changes = {}) {
    const Folder folder;
    const std::filesystem::path file = folder.path() / "test.deck";
    std::ofstream(file) << text;
    deck = program::read_ready(file, {}, program::Log(program::LogFormat::text));
    base::Diagnostics diagnostics;
    if (!deck.model) {
      throw std::invalid_argument("the deck is refused");
    }
    if (changes.model) {
      changes.model(*deck.model);
    }
    const analysis::RegionPlan plan = analysis::plan_region(*deck.model, {0.0}, diagnostics);
    scene = analysis::make_scene(*deck.model, 0.0, plan, diagnostics);
    if (!scene) {
      for (const base::Diagnostic& d : diagnostics.all()) {
        ADD_FAILURE() << d.text;
      }
      return;
    }
    if (changes.scene) {
      changes.scene(*scene, *deck.model);
    }
    analysis::CondenseLog log;
    bodies = analysis::condense_bodies({*deck.model, scene->cracked.mesh, scene->cls, scene->ties,
                                        scene->rest_element,
                                        analysis::loads_with_supports(*deck.model, *scene), 1},
                                       cache, log);
    solver = std::make_unique<analysis::StepSolver>(*deck.model, *scene, bodies);
    adjoints = std::make_unique<analysis::Adjoints>(*deck.model, *scene, bodies);
    sensitivities = std::make_unique<analysis::Sensitivities>(*deck.model, *scene, bodies);
  }
  [[nodiscard]] const model::Model& model() const { return *deck.model; }

  /// The end of a step, the next of the deck; empty with a failure.
  std::optional<analysis::StepState> solve(std::size_t step) {
    analysis::Refusal refusal;
    std::optional<analysis::StepState> state;
    if (solver) {
      state = solver->solve(model().steps.at(step), refusal);
    }
    if (!state) {
      ADD_FAILURE() << "not solved: " << refusal.why;
    }
    return state;
  }

  /// The same with K and its derivatives.
  std::optional<results::StepResult> found(std::size_t step) {
    const std::optional<analysis::StepState> state = solve(step);
    if (!state) {
      return std::nullopt;
    }
    results::StepResult out =
        analysis::gather_step(model(), *scene, bodies, model().steps.at(step), *state);
    sensitivities->add(*solver, *state, *adjoints, out);
    return out;
  }

  /// What z and w turn into K, at the end of the last step.
  [[nodiscard]] base::Vec2 intensity(const estimate::Adjoint& adjoint) const {
    const base::Vector& factor = solver->factors().case_factor;
    base::Vector gap = base::Vector::Zero(static_cast<Eigen::Index>(scene->table.size()));
    if (solver->system() != nullptr) {
      const contact::ContactSystem::Demand demand = solver->demand();
      for (std::size_t i = 0; i < demand.rows.size(); ++i) {
        gap[static_cast<Eigen::Index>(demand.rows[i])] = demand.gap[static_cast<Eigen::Index>(i)];
      }
    }
    return estimate::intensity_of(adjoint, {analysis::loads_with_supports(model(), *scene) * factor,
                                            scene->case_displacement * factor, gap});
  }
};

} // namespace spricka::test
