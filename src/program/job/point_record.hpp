// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "results/sweep.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace spricka::program {

/// Values of the swept parameters at one point of a sweep.
using SweepPointValues = std::vector<std::pair<std::string, double>>;

/// The file by which the folder of a sweep's point is known to be complete.
inline constexpr const char* point_record_name = "point.json";

/// What the name of a folder ends with that holds nothing but the record of a point without
/// results: "007.failed".
inline constexpr const char* failed_point_ending = ".failed";

/// Whether a run that ends so has results.
constexpr bool has_results(base::ProgramOutcome outcome) {
  return outcome == base::ProgramOutcome::done || outcome == base::ProgramOutcome::check_failed;
}

/// The record of a point that was tried: digest of its deck, version, values, outcome and cells.
/// Numbers read back to the same bits.
std::string point_record_text(const SweepPointValues& values, const results::SweepPoint& point,
                              const std::string& digest);

/// The record in a point's folder; empty if there is none, it is not whole, it tells of results
/// that are not there, or its digest is another one.
std::optional<results::SweepPoint> read_point_record(const std::filesystem::path& folder,
                                                     const std::string& digest);

/// The values of the parameters in such a file; empty where it is no record. Throws
/// std::system_error where it cannot be read.
SweepPointValues read_point_values(const std::filesystem::path& record);

/// "delta = 0.084, mu = 0": a point of a sweep in words.
std::string sweep_point_text(const SweepPointValues& point);

} // namespace spricka::program
