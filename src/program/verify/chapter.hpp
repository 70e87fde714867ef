// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/verify/problems.hpp"
#include "program/verify/verification.hpp"

#include <string>
#include <vector>

namespace spricka::program {

/// The chapter of the manual, manual/verification.md: totals, problems, a row for each deck and
/// run. The single checks are in verification_csv, a file `table_name` beside the chapter.
std::string verification_chapter(const Verification& verification,
                                 const std::vector<BenchmarkProblem>& problems,
                                 const std::string& table_name);

} // namespace spricka::program
