// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "run/gather.hpp"
#include "run/one_run.hpp"
#include "run/sensitivities.hpp"
#include "run_text.hpp"

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
    std::function<void(run::Scene&, const model::Model&)> scene;
  };

  run::ReadyDeck deck;
  std::optional<run::Scene> scene;
  run::CondensationCache cache;
  std::vector<run::BodyNet> bodies;
  std::unique_ptr<run::StepSolver> solver;
  std::unique_ptr<run::Adjoints> adjoints;
  std::unique_ptr<run::Sensitivities> sensitivities;

  explicit SolvedScene(const std::string& text, const Changes& changes = {}) {
    const Folder folder;
    const std::filesystem::path file = folder.path() / "test.deck";
    std::ofstream(file) << text;
    deck = run::read_ready(file, {}, run::Log(run::LogFormat::text));
    base::Diagnostics diagnostics;
    if (!deck.model) {
      throw std::invalid_argument("the deck is refused");
    }
    if (changes.model) {
      changes.model(*deck.model);
    }
    const run::RegionPlan plan = run::plan_region(*deck.model, {0.0}, diagnostics);
    scene = run::make_scene(*deck.model, 0.0, plan, diagnostics);
    if (!scene) {
      for (const base::Diagnostic& d : diagnostics.all()) {
        ADD_FAILURE() << d.text;
      }
      return;
    }
    if (changes.scene) {
      changes.scene(*scene, *deck.model);
    }
    run::CondenseLog log;
    bodies = run::condense_bodies({*deck.model, scene->cracked.mesh, scene->cls, scene->ties,
                                   scene->rest_element,
                                   run::loads_with_supports(*deck.model, *scene), 1},
                                  cache, log);
    solver = std::make_unique<run::StepSolver>(*deck.model, *scene, bodies);
    adjoints = std::make_unique<run::Adjoints>(*deck.model, *scene, bodies);
    sensitivities = std::make_unique<run::Sensitivities>(*deck.model, *scene, bodies);
  }
  [[nodiscard]] const model::Model& model() const { return *deck.model; }

  /// The end of a step, the next of the deck; empty with a failure.
  std::optional<run::StepState> solve(std::size_t step) {
    run::Refusal refusal;
    std::optional<run::StepState> state;
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
    const std::optional<run::StepState> state = solve(step);
    if (!state) {
      return std::nullopt;
    }
    results::StepResult out =
        run::gather_step(model(), *scene, bodies, model().steps.at(step), *state);
    sensitivities->add(*solver, *state, *adjoints, out);
    return out;
  }

  /// What z and w turn into K, at the end of the last step.
  [[nodiscard]] base::Vec2 intensity(const estimate::Adjoint& adjoint) const {
    const base::Vector& factor = solver->factors().case_factor;
    base::Vector gap = base::Vector::Zero(static_cast<Eigen::Index>(scene->table.rows.size()));
    if (solver->system() != nullptr) {
      const contact::ContactSystem::Demand demand = solver->demand();
      for (std::size_t i = 0; i < demand.rows.size(); ++i) {
        gap[static_cast<Eigen::Index>(demand.rows[i])] = demand.gap[static_cast<Eigen::Index>(i)];
      }
    }
    return estimate::intensity_of(adjoint, {run::loads_with_supports(model(), *scene) * factor,
                                            scene->case_displacement * factor, gap});
  }
};

} // namespace spricka::test
