// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/results.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace spricka::program {

/// What one deck has found, as its run folder says it: the run, or one point of a sweep.
struct DeckRunChecks {
  std::string values = {};  ///< of the point, "beta = 0.785398"; empty: no sweep
  std::size_t unknowns = 0; ///< of the largest of its increments
  std::vector<results::CheckResult> checks = {};
  std::string title = {};
};

/// The outcome in a run folder, or one for each point of the folder of a sweep, in order; those
/// that have no results are left out. Throws std::system_error or results::StoreError for files
/// that cannot be read.
std::vector<DeckRunChecks> read_run_folder_checks(const std::filesystem::path& folder);

/// The first line with an error among the messages of a run, else the last that is not blank.
std::string first_error_line(const std::string& messages);

} // namespace spricka::program
