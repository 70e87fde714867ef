// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/adjoint/frozen_change.hpp"
#include "estimate/adjoint.hpp"

#include <optional>
#include <vector>

/// The adjoint of K on the condensed bodies: no large matrix is factorised again.
namespace spricka::analysis {

class KAdjoints {
public:
  /// All must outlive it; nothing is computed yet.
  KAdjoints(const model::Model& model, const Discretisation& scene,
            const std::vector<SubstructuredBody>& bodies);

  /// [tip] of the step that was solved last, its contact frozen as it ended; steps that end with
  /// the same rows closed share the answer. The rows are those of the tips' fields.
  const std::vector<estimate::IntensityAdjoint>& solve_last_step(const StepSolver& solver);
  /// The contact of that answer; null where there is none or contacts rub.
  [[nodiscard]] const contact::FixedActiveSet* held_contact() const {
    return held_ ? held_->held_contact() : nullptr;
  }

  /// [tip] with these rows of the table closed, which `system` holds.
  std::vector<estimate::IntensityAdjoint> solve_closed_set(const FrozenContactSystem& system,
                                                           const std::vector<bool>& closed);

private:
  void condense_rows();

  const model::Model& model_;
  const Discretisation& scene_;
  const std::vector<SubstructuredBody>& bodies_;
  std::vector<base::Matrix> rows_; ///< [tip][dim * node, 2]
  CondensedLoads condensed_;       ///< columns: K1 and K2 of the first tip, of the next ..
  base::Matrix by_force_;          ///< [table row, crack::KLayout] of forces between crack faces
  std::optional<FrozenContactSystem> held_;
  std::vector<estimate::IntensityAdjoint> last_;
};

} // namespace spricka::analysis
