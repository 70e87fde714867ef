// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/forward.hpp"
#include "results/results.hpp"

#include <span>
#include <vector>

namespace spricka::analysis {

/// At the ends of which steps of a crack length stresses are recovered.
struct PicturedSteps {
  std::vector<bool> known; ///< [step]
  /// And the most loaded one (results/shown_step.hpp), which is known when all are solved.
  bool most_loaded = false;
};

/// Stresses are recovered where something shows them: at the shown step (results/shown_step.hpp),
/// and where an output asks for pictures or stresses or a check for their error. `solved`: lengths
/// that have been solved, the first of which tells the shown step.
PicturedSteps steps_with_stress_recovery(const model::Model& model,
                                         std::span<const results::CrackLengthResult> solved,
                                         bool last_increment);

/// The same, of outputs and checks alone.
PicturedSteps steps_with_requested_stresses(const model::Model& model, bool last_increment);

} // namespace spricka::analysis
