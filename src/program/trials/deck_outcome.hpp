// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/named_columns.hpp"
#include "results/results.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace spricka::program {

/// What one deck has found, as its run folder says it: the run, or one point of a sweep.
struct DeckOutcome {
  std::string title;
  std::string program; ///< "spricka 0.1.0"
  /// Swept parameters and their values; empty: no sweep.
  std::vector<std::pair<std::string, double>> point;
  std::vector<results::CheckResult> checks;
  std::vector<std::string> warnings;
  std::size_t unknowns = 0; ///< of the largest of its increments
  /// The tables `k`, in space `fronts`, and `pressure` of results.h5 (manual/results_file.md);
  /// without columns where there is none.
  results::ColumnTable k, pressure;
};

/// The outcome in a run folder, or one for each point of the folder of a sweep, in order; those
/// that have no results are left out. Throws std::system_error or results::StoreError for files
/// that cannot be read.
std::vector<DeckOutcome> read_outcomes(const std::filesystem::path& folder);

/// A column of numbers; empty if there is none of that name.
std::vector<double> number_column(const results::ColumnTable& table, const std::string& column);
/// A column of words; empty if there is none of that name.
std::vector<std::string> text_column(const results::ColumnTable& table, const std::string& column);

} // namespace spricka::program
