// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/checks/field_quantities.hpp"
#include "results/results.hpp"

#include <string>

namespace spricka::program {

/// PATH.K1, PATH.OPENING and their like of $CHECK. What a path does not cover is Missing: nothing
/// is extrapolated.
double path_quantity(const std::string& quantity, Arguments& args, const results::Run& run);

} // namespace spricka::program
