// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "report/drawing/table.hpp"
#include "report/topics/figures.hpp"
#include "results/results.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// What the spectrum of a growth consists of: levels, ranges, and what they do.
namespace spricka::report {

/// Its cycles by their peaks and by their ranges, with their parts of growth and life. No tables
/// without a spectrum, or where all cycles are alike.
std::vector<ReportTable> spectrum_tables(const model::Model& model, const results::RunResult& run);

/// Writes spectrum.csv, the rows of these tables. Nothing is written without a spectrum.
void write_spectrum_csv(const std::filesystem::path& file, const model::Model& model,
                        const results::RunResult& run);

/// How the spectrum was made and counted, what CLIP and OMIT did, and the lives by other ways of
/// reading it: lines of text; empty without a spectrum.
std::string spectrum_summary(const model::Model& model, const results::RunResult& run);

/// How often one pass exceeds each load, by cycles of which ranges, and what the levels do to the
/// crack; none of a spectrum of one level, which there is nothing to show of.
std::optional<Figure> exceedance_figure(const model::Model& model,
                                        const results::GrowthResult& growth);

} // namespace spricka::report
