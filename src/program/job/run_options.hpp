// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/clock.hpp"
#include "base/equation_engines.hpp"
#include "model/forward.hpp"
#include "program/job/array_task.hpp"
#include "program/job/log_format.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace spricka::analysis {
class ProfileRecorder;
}

namespace spricka::program {

/// What the command line asks of a run, a check or a sweep.
struct RunOptions {
  std::filesystem::path deck;
  std::filesystem::path out; ///< empty: the deck's name with .run, in the working directory
  std::vector<std::pair<std::string, std::string>> defines;
  int threads = -1;        ///< below 0: as the scheduler or $CONTROL says; 0: all cores
  std::string engine = {}; ///< of the equations, by its word; empty: as $CONTROL says
  bool quiet = false;
  bool restart = false;  ///< go on from the deck's own $RESTART WRITE file, if it is there
  double seconds = 0.0;  ///< wall time after which no increment is begun; 0: no limit
  base::Stopwatch since; ///< when the program was started
  bool profile = false;  ///< tell what the run costs, processor by processor
  std::shared_ptr<analysis::ProfileRecorder> recorder = {}; ///< takes it down; null: nobody does
  bool sweep_only = false;                                  ///< a deck without $SWEEP is refused
  std::optional<ArrayTask> array; ///< the runs of this task alone; empty: all
  bool collect = false;           ///< run nothing: tables of what the tasks of an array have run
  bool check_only = false;
  bool exact_forecast = false; ///< check: by the symbolic analysis of the matrices
  bool json = false;           ///< check: the same as JSON
  LogFormat log_format = LogFormat::text;
};

/// As the command line says, else what the scheduler gives a task, else $CONTROL; 0 means all
/// cores.
int thread_count(const RunOptions& options, const model::Model& model);

/// As the command line says, else $CONTROL.
base::EquationEngine requested_engine(const RunOptions& options, const model::Model& model);

} // namespace spricka::program
