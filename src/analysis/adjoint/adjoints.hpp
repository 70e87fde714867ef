// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/adjoint/frozen_change.hpp"
#include "analysis/scene/front_functionals.hpp"

#include <optional>
#include <string>
#include <vector>

/// The adjoint of K on the condensed bodies: no large matrix is factorised again.
namespace spricka::analysis {

/// K of all fronts (columns, by the scene's k_layout) at the end of one step as functions of loads
/// and gaps while the contact stays as it is: what is closed stays closed, what is open stays open
/// (manual, sensitivity.1 to 5).
struct StressIntensityAdjoints {
  std::string why_not;   ///< why there is none; empty: there is one
  base::Matrix rows;     ///< [dim * node, K] K = rows^T u + by_force^T lambda
  base::Matrix by_force; ///< [contact row, K] what forces between crack faces add to K themselves
  base::Matrix z;        ///< [dim * node, K] displacements under the load `rows`, closed rows held
                  ///< at the gap -by_force, open ones free; zero on supports, tied where u is
  base::Matrix w;           ///< [contact row, K] their contact forces, dK/dgap; zero on open rows
  std::vector<bool> closed; ///< [contact row] what was held; rows that are not in force: false

  [[nodiscard]] bool is_available() const { return why_not.empty(); }
};

class IntensityAdjointSolver {
public:
  /// All must outlive it; nothing is computed yet.
  IntensityAdjointSolver(const Discretisation& scene, const std::vector<SubstructuredBody>& bodies,
                         const KFunctionals& K);

  /// Of the step that was solved last, its contact frozen as it ended; steps that end with the same
  /// rows closed share the answer.
  const StressIntensityAdjoints& solve_adjoint_of_last_step(const StepSolver& solver);
  /// The contact of that answer; null where there is none or contacts rub.
  [[nodiscard]] const contact::FixedActiveSet* fixed_active_set() const {
    return held_ ? held_->fixed_active_set() : nullptr;
  }

  /// With these rows of the table closed, which `system` holds.
  StressIntensityAdjoints solve_with_closed_rows(const FrozenContactSystem& system,
                                                 const std::vector<bool>& closed);

private:
  const Discretisation& scene_;
  const std::vector<SubstructuredBody>& bodies_;
  const KFunctionals& K_;
  base::Matrix rows_;        ///< [dim * node, K]
  CondensedLoads condensed_; ///< those
  base::Matrix by_force_;    ///< [table row, K] of forces between crack faces
  std::optional<FrozenContactSystem> held_;
  std::optional<StressIntensityAdjoints> last_;
};

} // namespace spricka::analysis
