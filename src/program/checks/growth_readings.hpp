// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "program/checks/field_quantities.hpp"
#include "results/results.hpp"

#include <string>
#include <vector>

namespace spricka::program {

/// Every $TEST against the run: rates from its readings, K from the rates (manual, inversion.md),
/// beside K of the increments at the step KMAX of $GROW, interpolated in log K over log a.
std::vector<results::GrowthTestResult> invert_growth_tests(const model::Model& model,
                                                           const results::RunResult& run);

/// TEST.K, TEST.RATIO and their like of $CHECK.
double evaluate_growth_test_quantity(const std::string& quantity, CheckArguments& args,
                                     const results::RunResult& run);

} // namespace spricka::program
