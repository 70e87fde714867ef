// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <condition_variable>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <mutex>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <sys/types.h>

/// Decks run as processes of their own: what brings one down, or eats its memory, concerns no
/// other, and the system counts what each of them took.
namespace spricka::program {

/// `spricka run DECK --quiet --threads N --out FOLDER --engine WORD -D NAME=VALUE ..`, or another
/// program.
struct ChildRun {
  std::filesystem::path deck;
  std::filesystem::path out; ///< its run folder
  std::vector<std::pair<std::string, std::string>> defines;
  int threads = 1;
  std::string engine = {};  ///< empty: as the program chooses
  double seconds = 0.0;     ///< wall time after which it is ended; 0: as long as it takes
  double cpu_seconds = 0.0; ///< the same of its CPU time
  /// Another program, by its file, and what it is given; then the deck is of no account.
  std::vector<std::string> other = {};
};

/// How such a process has ended.
struct ChildProcessResult {
  int exit_code = 0; ///< 128 + signal where a signal has ended it, as a shell says it
  int signal = 0;    ///< 0: none
  bool late = false; ///< ended by a time limit
  double cpu = 0.0;  ///< [s] of the process and of its mesher
  double wall = 0.0; ///< [s]
  /// [bytes] largest resident set, of it or of its mesher. Where it is less than this program has
  /// had itself, which the system counts as the process's own, it is what was seen while it ran.
  std::size_t peak_memory = 0;
  std::string messages; ///< the end of what it wrote to stderr
  std::string machine;  ///< of a run that a task of a job array has done; empty: this one
};

/// Memory as tables have it [MB], of bytes.
inline double megabytes(std::size_t bytes) {
  return 1e-6 * static_cast<double>(bytes);
}

/// The file of the running program.
std::filesystem::path running_program_file();

/// Starts such processes, several at once.
class ChildRunner {
public:
  explicit ChildRunner(std::filesystem::path program = running_program_file());

  /// Runs all, at most `at_once` at a time, begun in their order. `ended` is called with the index
  /// of each when it has ended, from any thread, one call at a time. Throws std::system_error where
  /// a process cannot be started, when those that run have ended.
  void run_all_children(std::span<const ChildRun> runs, int at_once,
                        const std::function<void(std::size_t, const ChildProcessResult&)>& ended);

  /// From any thread: ends those that run, which remove what they have begun to write, begins no
  /// more, and comes back when none is left.
  void stop();
  [[nodiscard]] bool stopped() const;

private:
  [[nodiscard]] bool start(const ChildRun& run, pid_t& pid, int& words);
  ChildProcessResult reap(pid_t pid, std::size_t seen, std::size_t inherited);

  std::filesystem::path program_;
  mutable std::mutex guard_;
  std::condition_variable gone_;
  std::set<pid_t> running_; ///< not yet reaped
  bool stopped_ = false;
  std::mutex telling_;
};

/// What times were measured on: "Intel(R) Xeon(R) CPU @ 2.20GHz, 2 cores, 24 GB".
std::string machine_description();

/// Cores that this process may use; not more than the scheduler gives its task.
int core_count();

/// What was measured: "spricka 0.1.0 (4f1d22c8)", the digits from the bytes of the program's file,
/// so that two builds of one version are told apart.
std::string program_version_and_build();

} // namespace spricka::program
