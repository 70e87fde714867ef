// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/checks/field_quantities.hpp"
#include "results/results.hpp"

#include <optional>
#include <string>

namespace spricka::program {

/// PATH.SLOPE, PATH.OPENING and their like of $CHECK, but for K itself (front_quantities.hpp). What
/// a path does not cover is Missing: nothing is extrapolated.
double evaluate_path_quantity(const std::string& quantity, CheckArguments& args,
                              const results::RunResult& run);

/// The path of that name with the place t on it.
const results::LoadPathResult& find_load_path(const results::RunResult& run,
                                              const std::string& name, double t,
                                              std::optional<double> a);

/// Why K along a front, at a place of a load path, is no answer: K1 < 0, as at the end of a step.
/// Empty: it is one.
std::string negative_k1_reason(const results::FrontResult& front);

} // namespace spricka::program
