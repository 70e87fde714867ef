// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/adjoint/adjoints.hpp"

#include <string>
#include <vector>

namespace spricka::analysis {

/// What displacements and contact forces change by as loads and gaps do, rows that are closed
/// staying so and open ones open: one back-substitution for each column.
struct FrozenContactResponse {
  base::Matrix u;                      ///< [dim * node, k]
  base::Matrix force;                  ///< [row of the table, k]
  contact::UnconstrainedResponse free; ///< without contact forces, where there are contacts
  std::string why_not;                 ///< empty: there is one
};

/// All must outlive it.
class FrozenContactSystem {
public:
  FrozenContactSystem(const StepSolver& solver, const Discretisation& scene,
                      const std::vector<SubstructuredBody>& bodies,
                      const std::vector<bool>& closed);

  /// Loads [dim * node, k], of which only those on independent freedoms count once ties are
  /// reduced; gaps [row, k], or no columns.
  [[nodiscard]] FrozenContactResponse solve_response(base::Matrix loads,
                                                     const base::Matrix& gaps) const;
  [[nodiscard]] const contact::FixedActiveSet* held_contact() const { return held_.get(); }

private:
  const StepSolver& solver_;
  const Discretisation& scene_;
  const std::vector<SubstructuredBody>& bodies_;
  std::unique_ptr<contact::FixedActiveSet> held_;
};

} // namespace spricka::analysis
