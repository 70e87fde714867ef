// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "run/adjoints.hpp"
#include "run/one_run.hpp"
#include "run_text.hpp"

#include <memory>
#include <optional>

namespace spricka::test {

/// A deck given as text, its steps walked one by one: what the processors leave is open to look at.
struct SolvedScene {
  run::ReadyDeck deck;
  std::optional<run::Scene> scene;
  run::CondensationCache cache;
  std::vector<run::BodyNet> bodies;
  std::unique_ptr<run::StepSolver> solver;
  std::unique_ptr<run::Adjoints> adjoints;

  explicit SolvedScene(const std::string& text) {
    const Folder folder;
    const std::filesystem::path file = folder.path() / "test.deck";
    std::ofstream(file) << text;
    deck = run::read_ready(file, {}, run::Log(run::LogFormat::text));
    base::Diagnostics diagnostics;
    if (!deck.model) {
      return;
    }
    const run::RegionPlan plan = run::plan_region(*deck.model, {0.0}, diagnostics);
    scene = run::make_scene(*deck.model, 0.0, plan, diagnostics);
    if (!scene) {
      for (const base::Diagnostic& d : diagnostics.all()) {
        ADD_FAILURE() << d.text;
      }
      return;
    }
    run::CondenseLog log;
    bodies = run::condense_bodies({*deck.model, scene->cracked.mesh, scene->cls, scene->ties,
                                   scene->rest_element,
                                   run::loads_with_supports(*deck.model, *scene), 1},
                                  cache, log);
    solver = std::make_unique<run::StepSolver>(*deck.model, *scene, bodies);
    adjoints = std::make_unique<run::Adjoints>(*deck.model, *scene, bodies);
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
