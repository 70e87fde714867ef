// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/recover/load_path_fronts.hpp"
#include "analysis/recover/load_path_functionals.hpp"
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_solver.hpp"
#include "model/steps.hpp"
#include "results/load_path.hpp"
#include "results/results.hpp"
#include "solve/parametric.hpp"

#include <map>
#include <vector>

/// Processor LOADPATH: K and contact on the straight paths between steps, by one parametric
/// solution for each.
namespace spricka::analysis {

class LoadPathSolver {
public:
  LoadPathSolver(const model::Model& model, const Discretisation& scene,
                 const std::vector<SubstructuredBody>& bodies, const KFunctionals& K);

  /// Keeps what paths that begin or end at this step need; called behind each step.
  void store_step_end_state(std::size_t step, const StepSolver& solver,
                            const results::LoadStepResult& result);
  /// All paths of the model, once the steps are done.
  [[nodiscard]] std::vector<results::LoadPathResult> solve_paths(const StepSolver& solver);
  /// Crack lines whose faces would overlap somewhere on the paths followed, and that have no pair
  /// yet (analysis/steps/crack_face_contact.hpp).
  [[nodiscard]] const std::vector<std::size_t>& cracks_with_overlapping_faces() const {
    return overlapping_;
  }
  /// K of each tip in a solved increment [crack::KLayout], along fronts in space the smooth one; K1
  /// is 0 where its faces touch at the tip, or in the plane what a law with R < 0 wants there.
  /// Looks at the faces, too.
  [[nodiscard]] base::Vector
  evaluate_increment_K(const contact::ContactSystem::IncrementProblem& problem,
                       const contact::ContactSystem::IncrementSolution& solution,
                       const StepSolver& solver);
  /// The parametric problem of one path; its functionals are those of LoadPathFunctionals.
  [[nodiscard]] solve::ParametricProblem
  parametric_path_problem(const model::LoadPathDefinition& card, const StepSolver& solver);

private:
  [[nodiscard]] results::LoadPathResult path(const model::LoadPathDefinition& card,
                                             const StepSolver& solver);

  const model::Model& model_;
  const Discretisation& scene_;
  std::map<std::size_t, LoadPathEndStep> ends_; ///< by step
  LoadPathFunctionals functionals_;
  std::vector<std::size_t> overlapping_; ///< crack lines
};

} // namespace spricka::analysis
