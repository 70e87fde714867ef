// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/bodies/condense_bodies.hpp"
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_solver.hpp"
#include "contact/held_contact.hpp"
#include "estimate/adjoint.hpp"

#include <memory>
#include <vector>

/// The adjoint of K on the condensed bodies: no large matrix is factorised again.
namespace spricka::analysis {

/// Which rows of the table the step that was solved last ended with closed, and whether some rub.
struct ClosedContactRows {
  std::vector<bool> closed; ///< [row of the table]
  bool rubs = false;
};
/// Contact rows that are closed at the end of the last step, equality rows among them; all open
/// where nothing is in contact.
ClosedContactRows closed_rows(const StepSolver& solver, const Discretisation& scene);
/// Why K has neither bars nor derivatives where some rub.
inline constexpr const char* depends_on_history =
    "contacts rub: the change of K depends on the load history";

/// The closed rows of the table [row] held; null where no body has externals.
std::unique_ptr<contact::FixedActiveSet> constrain_rows(const StepSolver& solver,
                                                        const std::vector<bool>& closed);

class KAdjoints {
public:
  /// All must outlive it; nothing is computed yet.
  KAdjoints(const model::Model& model, const Discretisation& scene,
            const std::vector<SubstructuredBody>& bodies);

  /// [tip] of the step that was solved last, its contact frozen as it ended; steps that end with
  /// the same rows closed share the answer. The rows are those of the tips' fields.
  const std::vector<estimate::IntensityAdjoint>& solve_last_step(const StepSolver& solver);
  /// The contact of that answer; null where there is none or contacts rub.
  [[nodiscard]] const contact::FixedActiveSet* held_contact() const { return held_.get(); }

  /// [tip] with these rows of the table closed, which `held` holds.
  std::vector<estimate::IntensityAdjoint> solve_closed_set(const StepSolver& solver,
                                                           const std::vector<bool>& closed,
                                                           const contact::FixedActiveSet* held);

private:
  void condense_rows();

  const model::Model& model_;
  const Discretisation& scene_;
  const std::vector<SubstructuredBody>& bodies_;
  std::vector<base::Matrix> rows_; ///< [tip][dim * node, 2]
  std::vector<CondensedLoad>
      condensed_; ///< [body] columns: K1 and K2 of the first tip, of the next ..
  std::vector<base::Matrix> external_;  ///< [body of the contact system] the same at externals
  contact::UnconstrainedResponse free_; ///< to those, where there is a contact system
  base::Matrix by_force_; ///< [table row, crack::KLayout] of forces between crack faces
  std::unique_ptr<contact::FixedActiveSet> held_;
  std::vector<estimate::IntensityAdjoint> last_;
};

} // namespace spricka::analysis
