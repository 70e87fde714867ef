// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/sweep.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace spricka::program {

/// The file by which the folder of a sweep's point is known to be complete.
inline constexpr const char* point_record_name = "point.json";

/// The record of a finished point: digest of its deck, version, values, outcome and cells. Numbers
/// read back to the same bits.
std::string point_record_text(const results::SweepResult& sweep, const results::SweepPoint& point,
                              const std::string& digest);

/// The record in a point's folder; empty if there is none, it is not whole, or its digest is
/// another one.
std::optional<results::SweepPoint> read_point_record(const std::filesystem::path& folder,
                                                     const std::string& digest);

/// The values of the parameters in such a file; empty where it is no record. Throws
/// std::system_error where it cannot be read.
std::vector<std::pair<std::string, double>> read_point_values(const std::filesystem::path& record);

/// "delta = 0.084, mu = 0": a point of a sweep in words.
std::string sweep_point_text(const std::vector<std::pair<std::string, double>>& point);

} // namespace spricka::program
