// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/verify/comparison.hpp"
#include "program/verify/problems.hpp"
#include "program/verify/verification.hpp"

#include <optional>
#include <string>
#include <vector>

namespace spricka::program {

/// verification.html: one page without script or network, in the style of report.html.
std::string verification_page(const Verification& verification,
                              const std::vector<BenchmarkProblem>& problems,
                              const std::optional<VerificationComparison>& comparison);

} // namespace spricka::program
