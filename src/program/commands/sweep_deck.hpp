// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "program/job/job.hpp"
#include "program/job/point_record.hpp"
#include "program/job/run_options.hpp"

#include <vector>

namespace spricka::program {

/// All points of a deck's $SWEEP cards: their product, the last card varying fastest.
std::vector<SweepPointValues> sweep_points(const model::Model& model);

/// Runs the deck once for each point, in order, each in its own folder OUT/001, OUT/002, .. and
/// writes sweep.csv, sweep.html and the tables of $OUTPUT EVERY=END into OUT after each point. A
/// point that fails is a row with its error. Points whose folder holds a result of the same deck,
/// values and program are taken over. Returns the worst outcome of all points. SIGINT and
/// SIGTERM end the program with 130 and 143; finished points stay. Of a task of a job array
/// (RunOptions::array) only its points are run, beside other tasks in the same folder and without
/// tables; a signal ends it as stopped. With RunOptions::collect nothing is run: tables of the
/// points that are there, and stopped where some are missing (E553). Throws std::system_error or
/// archive::FileFailure when OUT cannot be used.
base::ProgramOutcome run_sweep(const RunOptions& options, const CheckedDeck& deck, const Log& log);

} // namespace spricka::program
