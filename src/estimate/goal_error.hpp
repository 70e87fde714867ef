// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "estimate/mode_map.hpp"

#include <vector>

namespace spricka::estimate {

/// How far a linear functional of the displacements (K1 or K2 of a tip) is estimated to be off.
struct GoalError {
  double eta = 0.0;               ///< estimated exact value less that of the mesh
  double sum = 0.0;               ///< sum of |eta_e|: what would be left without cancellation
  std::vector<double> of_element; ///< eta_e [element]; they sum to eta

  /// Makes eta and sum those of the elements.
  void sum_element_errors();
};

/// What the estimate asks for at the end of a step.
struct GoalErrorInput {
  const base::Vector& u;     ///< [dim * node] the displacements
  const base::Matrix& z;     ///< [dim * node, goals] adjoints: the same stiffness, supports and
                             ///< closed rows, loaded by the functionals
  const base::Vector& load;  ///< [freedoms of modes] loads on the modes
  const base::Matrix& goals; ///< [freedoms of modes, goals] functionals on the modes
};

/// Residuals of the modes r_u = f_e - K_ep u and r_z = g_e - K_ep z (manual, estimate.3) on the
/// unknowns, and how many element freedoms each unknown is.
struct ModeResiduals {
  base::Vector u;         ///< [unknowns]
  base::Matrix z;         ///< [unknowns, goals]
  std::vector<int> users; ///< [unknown]
};
ModeResiduals mode_residuals(const CubicEnrichment& enrichment, const ModeFreedomMap& map,
                             const GoalErrorInput& request);

/// eta = r_z^T K_ee^-1 r_u with r_u = f_e - K_ep u and r_z = g_e - K_ep z (manual, estimate.4), by
/// conjugate gradients on the modes, preconditioned by the diagonal blocks of the direction pairs:
/// at most 8 steps, fewer where another one changes no eta by more than 0.3 %.
std::vector<GoalError> estimate_goal_errors(const CubicEnrichment& enrichment,
                                            const ModeFreedomMap& map,
                                            const GoalErrorInput& request);

} // namespace spricka::estimate
