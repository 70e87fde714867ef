// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/results.hpp"

#include <string>

namespace spricka::analysis {

/// What of a step's results is no number or too large for its squares to be one (1e150); empty:
/// nothing is.
std::string not_finite(const results::StepResult& step);

/// The same of K along a load path.
std::string not_finite(const results::LoadPathResult& path);

} // namespace spricka::analysis
