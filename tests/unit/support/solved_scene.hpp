// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/lengths/length.hpp"
#include "analysis/scene/scene_loads.hpp"
#include "model/model.hpp"
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
    std::function<void(analysis::Discretisation&, const model::Model&)> scene;
  };

  program::CheckedDeck deck;
  analysis::CondensationCache cache;
  std::unique_ptr<analysis::CrackLengthAnalysis> length; ///< null where the deck has no scene
  std::unique_ptr<analysis::StepSolver> solver;

  explicit SolvedScene(const std::string& text, const Changes& changes = {}) {
    const Folder folder;
    const std::filesystem::path file = folder.path() / "test.deck";
    std::ofstream(file) << text;
    deck = program::read_and_check_deck(file, {}, program::Log(program::LogFormat::text));
    base::Diagnostics diagnostics;
    if (!deck.model) {
      throw std::invalid_argument("the deck is refused");
    }
    if (changes.model) {
      changes.model(*deck.model);
    }
    const analysis::CrackRegionPlan plan =
        analysis::plan_crack_region(*deck.model, {0.0}, diagnostics);
    std::optional<analysis::Discretisation> made =
        analysis::discretise(*deck.model, 0.0, plan, diagnostics);
    if (!made) {
      for (const base::Diagnostic& d : diagnostics.messages()) {
        ADD_FAILURE() << d.text;
      }
      return;
    }
    if (changes.scene) {
      changes.scene(*made, *deck.model);
    }
    length = std::make_unique<analysis::CrackLengthAnalysis>(
        analysis::CrackLengthContext{.model = *deck.model, .cache = cache}, std::move(*made));
    analysis::CondensationStatistics log;
    if (!length->condense(log)) {
      ADD_FAILURE() << log.trouble->why;
      return;
    }
    solver = length->make_solver();
  }
  [[nodiscard]] const analysis::Discretisation& scene() const { return length->discretisation(); }
  [[nodiscard]] const model::Model& model() const { return *deck.model; }

  /// The end of a step, the next of the deck; empty with a failure.
  std::optional<analysis::StepState> solve(std::size_t step) {
    base::OptionalFailure trouble;
    std::optional<analysis::StepState> state;
    if (solver) {
      state = solver->solve(model().steps.at(step), trouble);
    }
    if (!state) {
      ADD_FAILURE() << "not solved: " << (trouble ? trouble->why : "no scene");
    }
    return state;
  }

  /// The same with K and its derivatives.
  std::optional<results::LoadStepResult> found(std::size_t step) {
    const std::optional<analysis::StepState> state = solve(step);
    if (!state) {
      return std::nullopt;
    }
    results::LoadStepResult out = length->recover_step(model().steps.at(step), *state);
    length->add_error_bars_and_sensitivities(
        *solver, *state, true, out, [](const std::string&, const std::string&) { return true; });
    return out;
  }

  /// What z and w turn into K (manual, sensitivity.5), at the end of the last step.
  [[nodiscard]] base::Vector intensity(const analysis::StressIntensityAdjoints& adjoint) const {
    const base::Vector& factor = solver->factors().case_factor;
    base::Vector gap = base::Vector::Zero(static_cast<Eigen::Index>(scene().table.size()));
    if (solver->contact_system() != nullptr) {
      const contact::ContactSystem::IncrementProblem problem = solver->contact_problem();
      for (std::size_t i = 0; i < problem.rows.size(); ++i) {
        gap[static_cast<Eigen::Index>(problem.rows[i])] = problem.gap[static_cast<Eigen::Index>(i)];
      }
    }
    const base::Vector load = analysis::reduced_case_loads(model(), scene()) * factor;
    const base::Vector prescribed = scene().case_displacement * factor;
    return adjoint.z.transpose() * load + adjoint.rows.transpose() * prescribed +
           adjoint.w.transpose() * gap;
  }
};

} // namespace spricka::test
