// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/output_unit.hpp"
#include "model/forward.hpp"
#include "report/drawing/table.hpp"
#include "report/topics/figures.hpp"
#include "results/results.hpp"

#include <filesystem>
#include <vector>

/// What the run folder shows of load paths.
namespace spricka::report {

/// A place on a contact as tables show it: an angle on a circle in degrees, else the length in its
/// unit.
double contact_place_as_written(const results::LoadPathContact& contact, double place,
                                const base::OutputUnit& length);

/// load_path.csv: one row for each breakpoint, first and last t of each path and increment:
/// increment,path,t,changes, then of each tip K1,K2 and their slopes before and behind, then of
/// each contact the closed pairs and the first and last of them behind the breakpoint (angles in
/// degrees). Nothing is written without paths.
void write_K_along_load_path_csv(const std::filesystem::path& file, const model::Model& model,
                                 const results::RunResult& run);

/// load_path_fronts.csv: K1, K2, K3 and their slopes of each point of a front in space, one row for
/// each point and t. Nothing is written without cracks in space.
void write_load_path_fronts_csv(const std::filesystem::path& file, const model::Model& model,
                                const results::RunResult& run);

/// K1 and its slope at both ends and the sharpest kink, for each path and tip; of a
/// front its points with the largest and the smallest K1.
ReportTable load_path_table(const model::Model& model, const results::CrackLengthResult& increment);
/// When each contact begins to open, and what is closed at both ends.
ReportTable contact_opening_onset_table(const model::Model& model,
                                        const results::CrackLengthResult& increment);

/// K1 over t and its slope, with the kinks; one figure for each path, at most six lengths.
std::vector<Figure> load_path_figures(const model::Model& model, const results::RunResult& run);

} // namespace spricka::report
