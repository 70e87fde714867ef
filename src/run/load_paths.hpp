// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/load_path.hpp"
#include "results/results.hpp"
#include "run/scene.hpp"
#include "run/step_solver.hpp"
#include "solve/parametric.hpp"

#include <map>
#include <optional>
#include <vector>

/// Processor LOADPATH: K and contact on the straight paths between steps, by one parametric
/// solution for each.
namespace spricka::run {

class LoadPaths {
public:
  LoadPaths(const model::Model& model, const Scene& scene, const std::vector<BodyNet>& bodies);

  /// Keeps what paths that begin or end at this step need; called behind each step.
  void keep(std::size_t step, const StepSolver& solver, const results::StepResult& result);
  /// All paths of the model, once the steps are done.
  [[nodiscard]] std::vector<results::LoadPath> follow(const StepSolver& solver);
  /// Crack lines whose faces would overlap somewhere on these paths, at their knots, and that have
  /// no pair yet (run/lip_contact.hpp).
  [[nodiscard]] std::vector<std::size_t>
  touching(const StepSolver& solver, const std::vector<results::LoadPath>& paths) const;
  /// The parametric problem of one path; functionals K1 and K2 of each tip.
  [[nodiscard]] solve::ParametricProblem pose(const model::LoadPath& card,
                                              const StepSolver& solver);

private:
  /// Loads and gaps at the end of a step.
  struct End {
    contact::ContactSystem::Demand demand;
    base::Vector case_factor;
    results::StepResult result; ///< without its fields
  };
  /// K1 and K2 of all tips by contact forces and rigid modes (manual, solve.32): one
  /// back-substitution for each.
  struct Functionals {
    base::Matrix of_row;  ///< [2 tip + mode - 1, row of the table]
    base::Matrix of_mode; ///< [2 tip + mode - 1, mode of the system]
  };
  [[nodiscard]] Functionals functionals(const StepSolver& solver) const;
  [[nodiscard]] base::Vector free_intensities(const base::Vector& case_factor) const;
  [[nodiscard]] solve::ParametricProblem problem(const End& from, const End& to,
                                                 const StepSolver& solver) const;
  [[nodiscard]] results::LoadPath path(const model::LoadPath& card, const StepSolver& solver);
  void contacts(const solve::SolutionPath& found, const End& end, results::LoadPath& path) const;
  void tips(const solve::SolutionPath& found, const End& from, const End& to,
            results::LoadPath& path) const;
  /// What contact forces between the faces of cracks add to K themselves, to of_row.
  void add_lip_forces(base::Matrix& of_row) const;
  /// Sets K1 of tip t to 0 on the segments on which its faces touch; whether there are any.
  bool close_tip(std::size_t t, const End& end, const solve::SolutionPath& found,
                 base::PiecewiseLinear& K1) const;
  [[nodiscard]] bool homogeneous(const End& from, const End& to, const StepSolver& solver) const;

  const model::Model& model_;
  const Scene& scene_;
  const std::vector<BodyNet>& bodies_;
  std::map<std::size_t, End> ends_; ///< by step
  std::optional<Functionals> rows_; ///< made once
};

} // namespace spricka::run
