// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/results.hpp"
#include "run/field_quantities.hpp"

#include <string>

namespace spricka::run {

/// PATH.K1, PATH.OPENING and their like of $CHECK. What a path does not cover is Missing: nothing
/// is extrapolated.
double path_quantity(const std::string& quantity, Arguments& args, const results::Run& run);

} // namespace spricka::run
