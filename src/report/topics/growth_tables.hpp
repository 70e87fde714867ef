// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "report/drawing/table.hpp"
#include "results/results.hpp"

#include <filesystem>
#include <string>

namespace spricka::report {

/// life.csv: the stations of a growth by a law, a row for each tip; life_curve.csv: a(N) between
/// them, a column for each tip. Columns in manual/run_folder.md. Nothing is written without one.
void write_life_csv(const std::filesystem::path& file, const model::Model& model,
                    const results::RunResult& run);
/// Writes life_curve.csv: the arms over the cycles, and the cycles of compared lives at the same
/// lengths.
void write_life_curve_csv(const std::filesystem::path& file, const model::Model& model,
                          const results::RunResult& run);

/// Stations of a growth by a law; without rows where there is none.
ReportTable growth_station_table(const model::Model& model, const results::RunResult& run);
/// The same of the points that are reported (front_places.hpp).
ReportTable reported_growth_station_table(const model::Model& model, const results::RunResult& run);
/// Lives by all rules of how cycles act on each other; without rows where there is none.
ReportTable compared_lives_table(const model::Model& model, const results::RunResult& run);
/// The rule that counts, as the deck calls it; NONE.
std::string first_interaction_name(const model::Model& model);
/// How it ended, after how many cycles, and how good they are: lines of text.
std::string life_summary(const model::Model& model, const results::RunResult& run);

/// What a life by one line of K is and how it compares, for legends: "one K scaled with the load:
/// 1/4.03 of the life".
std::string compared_life_legend(const results::ComparedLife& other);

} // namespace spricka::report
