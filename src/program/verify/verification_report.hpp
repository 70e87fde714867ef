// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/verify/comparison.hpp"
#include "program/verify/deck_list.hpp"
#include "program/verify/verification.hpp"

#include <optional>
#include <string>
#include <vector>

namespace spricka::program {

/// verification.html: one page that needs no network, in the style of report.html.
std::string verification_page(const Verification& verification,
                              const std::vector<BenchmarkProblem>& problems,
                              const std::optional<VerificationComparison>& comparison);

/// The chapter of the manual, manual/verification.md: totals, problems, a row for each deck and
/// run. The single checks are in verification_csv, a file `table_name` beside the chapter.
std::string verification_chapter(const Verification& verification,
                                 const std::vector<BenchmarkProblem>& problems,
                                 const std::string& table_name);

} // namespace spricka::program
