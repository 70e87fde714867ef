// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace spricka::program {

/// A task of a job array: many processes, on one machine or several, that share the runs of a
/// sweep, study or verification. Which runs a task has follows from its number alone.
struct ArrayTask {
  std::size_t number = 1; ///< from 1
  std::size_t count = 1;  ///< of all tasks

  /// Task K of N has the runs K, K+N, .., counted from 1; `index` counts from 0.
  [[nodiscard]] bool has_run(std::size_t index) const { return index % count == number - 1; }
};

/// The task that a text means: "K/N", or "slurm" for what Slurm says of its array by the variables
/// SLURM_ARRAY_TASK_ID, _MIN, _MAX, _STEP and _COUNT: the first index is task 1. Empty where it is
/// no task, and `why` says so: an array of Slurm must be a plain range, as --array=1-8.
std::optional<ArrayTask> parse_array_task(const std::string& text, std::string& why);

/// "2 of 200 points are missing in lug.run: 003, 007; run their tasks again ..": what a collector
/// says of runs that no task has finished. `kind`: "point", "run".
std::string missing_runs_text(const std::vector<std::string>& missing, std::size_t count,
                              const std::string& kind, const std::filesystem::path& folder);

/// CPUs that Slurm gives each task (SLURM_CPUS_PER_TASK); empty: it does not say.
std::optional<int> scheduler_cpu_count();

} // namespace spricka::program
