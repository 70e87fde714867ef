// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "results/results.hpp"

#include <string>

namespace spricka::report {

/// A section of a page in which the bodies can be turned and looked into, with all the scripts and
/// data it takes; on paper it is not there. Empty where nothing can be seen.
std::string view_section(const model::Model& model, const results::RunResult& run);

/// Where a page has plots, the script that tells the numbers of their curves under the pointer;
/// else empty.
std::string curve_script(const std::string& page);

} // namespace spricka::report
