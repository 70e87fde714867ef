// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/checks/field_quantities.hpp"
#include "results/results.hpp"

#include <optional>
#include <string>

namespace spricka::program {

/// PATH.K1, PATH.OPENING and their like of $CHECK. What a path does not cover is Missing: nothing
/// is extrapolated.
double path_quantity(const std::string& quantity, CheckArguments& args,
                     const results::RunResult& run);

/// The path of that name with the place t on it.
const results::LoadPathResult& find_load_path(const results::RunResult& run,
                                              const std::string& name, double t,
                                              std::optional<double> a);

} // namespace spricka::program
