// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/job/array_task.hpp"
#include "program/job/interrupt.hpp"
#include "program/job/sweep_folder.hpp"
#include "program/trials/child_run.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace spricka::program {

/// How the tasks of a job array share runs of decks.
struct SharedRunOptions {
  std::optional<ArrayTask> task = {}; ///< its runs alone are begun
  bool collect = false;               ///< none is begun: what tasks have left is read
  /// Where run folders stay, each with a record of how its run has ended.
  std::filesystem::path folder = {};
  /// Of what all runs depend on besides program and deck; a record of another one is none.
  std::string digest = {};

  [[nodiscard]] bool is_shared() const { return task || collect; }
};

/// Runs of decks in a new folder PREFIX.XXXXXX for decks and run folders, which is removed at the
/// end, whole; those of a job array have their run folders in a place that all tasks share, where
/// they stay. A signal ends all that run and removes the folder; then `stopped_by` may do what is
/// left, and the program ends, a task as stopped: it can be run again. Throws std::system_error
/// where no folder can be made, and archive::FileFailure where the shared one is somebody else's.
class DeckRuns {
public:
  /// `keep`: the folder stays at the end.
  DeckRuns(const std::filesystem::path& prefix, bool keep,
           std::function<void(int signal)> stopped_by, SharedRunOptions sharing = {});
  ~DeckRuns() { remove(); }
  DeckRuns(const DeckRuns&) = delete;
  DeckRuns& operator=(const DeckRuns&) = delete;
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// Where the run folder of that name goes.
  [[nodiscard]] std::filesystem::path run_folder(const std::string& name) const;
  [[nodiscard]] bool stopped() const { return runner_.stopped(); }
  /// As ChildRunner has it; the run folder of each goes when `ended` has seen it, unless it is
  /// kept. Of a task: of its runs, with those that it has finished before. Of a collector: of all
  /// that some task has finished.
  void run_all_children(std::span<const ChildRun> runs, int at_once,
                        const std::function<void(std::size_t, const ChildProcessResult&)>& ended);
  /// Run folders, by name, of runs that a task should have finished but did not, or that a
  /// collector has not found.
  [[nodiscard]] const std::vector<std::string>& missing_runs() const { return missing_; }

private:
  void remove() const;
  [[nodiscard]] std::string digest_of(const ChildRun& run) const;
  bool make_room(const ChildRun& run);

  std::filesystem::path folder_;
  bool keep_;
  SharedRunOptions sharing_;
  std::optional<SweepFolder> shared_; ///< open in a task and in a collector
  std::vector<std::string> missing_;
  ChildRunner runner_;
  InterruptHandler interrupt_;
};

} // namespace spricka::program
