// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/recover/crack_face_openings.hpp"
#include "analysis/scene/front_functionals.hpp"
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_solver.hpp"

#include <optional>
#include <vector>

namespace spricka::analysis {

/// Functionals by contact forces and rigid modes (manual, solve.32).
struct ContactAndRigidModeFunctionals {
  base::Matrix of_row;  ///< [functional, row of the table]
  base::Matrix of_mode; ///< [functional, mode of the system]
};

/// What is known along a load path, as linear functionals of its solution: K of each tip
/// [crack::KLayout], then the openings of crack faces.
class LoadPathFunctionals {
public:
  LoadPathFunctionals(const model::Model& model, const Discretisation& scene,
                      const std::vector<SubstructuredBody>& bodies, const KFunctionals& K)
      : model_(model), scene_(scene), bodies_(bodies), K_(K), openings_(model, scene) {}

  /// Of the bodies alone, without contact forces and rigid motions. [functional]
  [[nodiscard]] base::Vector evaluate_without_contact(const base::Vector& case_factor,
                                                      const StepSolver& solver);
  /// By one back-substitution for each functional; made once.
  [[nodiscard]] const ContactAndRigidModeFunctionals& contact_functionals(const StepSolver& solver);
  /// Of a solved increment. [functional]
  [[nodiscard]] base::Vector
  evaluate_increment(const contact::ContactSystem::IncrementProblem& problem,
                     const contact::ContactSystem::IncrementSolution& solution,
                     const StepSolver& solver);
  /// Adds crack lines to `lines` whose faces overlap by these values [functional], each once.
  void add_overlapping_crack_lines(const base::Vector& value,
                                   std::vector<std::size_t>& lines) const {
    openings_.add_overlapping_crack_lines(value.tail(openings_.count()), lines);
  }

private:
  [[nodiscard]] Eigen::Index K_count() const { return scene_.k_layout().count(); }
  [[nodiscard]] Eigen::Index count() const { return K_count() + openings_.count(); }
  [[nodiscard]] ContactAndRigidModeFunctionals condense_functionals(const StepSolver& solver);

  const model::Model& model_;
  const Discretisation& scene_;
  const std::vector<SubstructuredBody>& bodies_;
  const KFunctionals& K_;
  CrackFaceOpenings openings_;
  std::optional<ContactAndRigidModeFunctionals> of_contact_; ///< made once
  base::Matrix of_case_;                                     ///< [functional, case]; made once
};

} // namespace spricka::analysis
