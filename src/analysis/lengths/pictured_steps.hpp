// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/forward.hpp"

#include <vector>

namespace spricka::analysis {

/// Stresses are recovered where something shows them: at KMAX of a growth run, else at the last
/// step, and where an output asks for pictures or stresses or a check for their error. [step]
std::vector<bool> steps_with_stress_recovery(const model::Model& model, bool last_increment);

/// The same, of outputs and checks alone.
std::vector<bool> steps_with_requested_stresses(const model::Model& model, bool last_increment);

} // namespace spricka::analysis
