// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/source.hpp"
#include "model/forward.hpp"
#include "results/results.hpp"
#include "results/sweep.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// Tables and page of a sweep. Writers throw std::system_error.
namespace spricka::report {

/// The numbers of a run that sweep.csv shows, in units of output: the life, cycles or passes, of a
/// growth by a law; crack length of each increment; at each step's end the quantities of each tip
/// and of each contact that are for sweeps (results/k_quantities.hpp, results/contact_result.hpp),
/// of those that have a value.
std::vector<results::SweepResultValue> collect_sweep_values_of_run(const model::Model& model,
                                                                   const results::RunResult& run);

/// What a card $OUTPUT EVERY=END asks for as single numbers, at the end of KMAX or of the last step
/// of the last increment: K and CPRESS give what sweeps have of a tip, with a, and of a contact;
/// REACTION the sum; U and S the smallest and largest value of each component over the set.
std::vector<results::SweepResultValue>
collect_requested_end_values(const model::Model& model, const model::OutputFileRequest& output,
                             const results::RunResult& run);

/// sweep.csv: `# units` line, then the parameters, point, status, exit_code, error, checks, passed
/// and the columns of all points' cells; one row for each point tried. Cells of failed points are
/// empty. Requested cells of a card that names `file` follow.
void write_sweep_csv(const std::filesystem::path& file, const model::Model& model,
                     const results::SweepResult& sweep);

/// The table of one card $OUTPUT EVERY=END: the parameters, point, status, then what it asks for.
void write_sweep_request_csv(const std::filesystem::path& file, const model::Model& model,
                             const results::SweepResult& sweep);

/// sweep.html: K1 over the swept parameter, table of the points; nothing is loaded from elsewhere.
std::string sweep_page(const base::SourceTexts& sources, const model::Model& model,
                       const results::SweepResult& sweep);

/// "done", "check failed" or "failed".
std::string sweep_point_status(const results::SweepPoint& point);

} // namespace spricka::report
