// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/front_functionals.hpp"
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_solver.hpp"
#include "model/steps.hpp"
#include "results/load_path.hpp"
#include "results/results.hpp"
#include "solve/parametric.hpp"

#include <map>
#include <optional>
#include <vector>

/// Processor LOADPATH: K and contact on the straight paths between steps, by one parametric
/// solution for each.
namespace spricka::analysis {

class LoadPathSolver {
public:
  LoadPathSolver(const model::Model& model, const Discretisation& scene,
                 const std::vector<SubstructuredBody>& bodies);

  /// Keeps what paths that begin or end at this step need; called behind each step.
  void record_step(std::size_t step, const StepSolver& solver, const results::StepResult& result);
  /// All paths of the model, once the steps are done.
  [[nodiscard]] std::vector<results::LoadPathResult> solve_paths(const StepSolver& solver);
  /// Crack lines whose faces would overlap somewhere on the paths followed, and that have no pair
  /// yet (analysis/steps/crack_face_contact.hpp).
  [[nodiscard]] const std::vector<std::size_t>& cracks_with_overlapping_faces() const {
    return touching_;
  }
  /// K of each tip in a solved increment [crack::KLayout], along fronts in space the smooth one; K1
  /// is 0 where its faces touch at the tip, or in the plane what a law with R < 0 wants there.
  /// Looks at the faces, too.
  [[nodiscard]] base::Vector evaluate_K(const contact::ContactSystem::IncrementProblem& problem,
                                        const contact::ContactSystem::IncrementSolution& solution,
                                        const StepSolver& solver);
  /// The parametric problem of one path; functionals K1 and K2 of each tip, then by watch how far
  /// its two nodes are apart and how far along the face.
  [[nodiscard]] solve::ParametricProblem
  parametric_path_problem(const model::LoadPathDefinition& card, const StepSolver& solver);

private:
  /// Loads and gaps at the end of a step.
  struct LoadPathEnd {
    contact::ContactSystem::IncrementProblem problem;
    base::Vector case_factor;
    results::StepResult result; ///< without its fields
  };
  /// Two nodes that lie on one another, of faces that may meet.
  struct FaceNodePair {
    std::size_t line = 0;
    contact::ConstraintRow apart;
    std::optional<contact::ConstraintRow> along; ///< none in a half model
  };
  [[nodiscard]] static std::vector<FaceNodePair> watch_faces(const model::Model& model,
                                                             const Discretisation& scene);
  /// K of all tips, then two for each watch.
  [[nodiscard]] Eigen::Index first_watched() const { return scene_.k_layout().count(); }
  [[nodiscard]] Eigen::Index functional_count() const {
    return first_watched() + 2 * static_cast<Eigen::Index>(watches_.size());
  }
  /// Columns [dim * node] of functionals from `first` on, at most so many.
  [[nodiscard]] base::Matrix functional_columns(Eigen::Index first, Eigen::Index most) const;
  /// [point of front f] its row among those in force, if faces bear behind it.
  [[nodiscard]] std::vector<std::optional<std::size_t>>
  rows_behind(std::size_t f, const std::vector<std::size_t>& in_force) const;
  /// Smooth values along the fronts in space of those in `value` [K ..], in their place.
  void smooth_fronts(base::Vector& value) const;
  /// K1 = 0 at points behind which the faces touch.
  void close_points(const contact::ContactSystem::IncrementProblem& problem,
                    const contact::ContactSystem::IncrementSolution& solution,
                    base::Vector& value) const;
  /// Of watches, from displacements [dim * node].
  [[nodiscard]] base::Vector watched(const base::Vector& u) const;
  /// Adds lines to `touching_` whose faces overlap at a knot.
  void look_at_faces(const solve::SolutionPath& found);
  /// The same of one set of values [functional].
  void look_at_faces(const base::Vector& value);
  /// K1 and K2 of all tips by contact forces and rigid modes (manual, solve.32): one
  /// back-substitution for each.
  struct ContactForceFunctionals {
    base::Matrix of_row;  ///< [functional, row of the table]
    base::Matrix of_mode; ///< [functional, mode of the system]
  };
  [[nodiscard]] ContactForceFunctionals functionals(const StepSolver& solver);
  [[nodiscard]] base::Vector free_values(const base::Vector& case_factor) const;
  [[nodiscard]] solve::ParametricProblem problem(const LoadPathEnd& from, const LoadPathEnd& to,
                                                 const StepSolver& solver) const;
  [[nodiscard]] results::LoadPathResult path(const model::LoadPathDefinition& card,
                                             const StepSolver& solver);
  void contacts(const solve::SolutionPath& found, const LoadPathEnd& end,
                results::LoadPathResult& path) const;
  /// One front on a path, but for what its faces do.
  [[nodiscard]] results::LoadPathFront follow_front(std::size_t f, Eigen::Index first,
                                                    const solve::SolutionPath& found,
                                                    const results::FrontResult& is) const;
  /// K of all fronts, and how far it is from that of the steps at the path's ends.
  void fronts(const solve::SolutionPath& found, const LoadPathEnd& from, const LoadPathEnd& to,
              results::LoadPathResult& path) const;
  [[nodiscard]] bool homogeneous(const LoadPathEnd& from, const LoadPathEnd& to,
                                 const StepSolver& solver) const;

  const model::Model& model_;
  const Discretisation& scene_;
  const std::vector<SubstructuredBody>& bodies_;
  std::map<std::size_t, LoadPathEnd> ends_;     ///< by step
  crack::SparseLinearFunctionals K_rows_;       ///< made with rows_
  std::optional<ContactForceFunctionals> rows_; ///< made once
  base::Matrix of_case_; ///< [functional, case] of the bodies alone; made once
  std::vector<FaceNodePair> watches_;
  std::vector<std::size_t> touching_;
};

} // namespace spricka::analysis
