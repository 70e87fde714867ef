// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/results.hpp"

#include <string>

namespace spricka::analysis {

/// What of a step's results is no number or too large for its squares to be one (1e150); empty:
/// nothing is.
std::string find_nonfinite_result(const results::LoadStepResult& step);

/// The same of K along a load path.
std::string find_nonfinite_result(const results::LoadPathResult& path);

} // namespace spricka::analysis
