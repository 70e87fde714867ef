// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/trials/child_run.hpp"

#include "archive/safe_file.hpp"
#include "base/clock.hpp"
#include "base/input_file.hpp"
#include "base/memory.hpp"
#include "base/parallel.hpp"
#include "program/job/array_task.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <ctime>
#include <fstream>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sched.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/utsname.h>
#include <sys/wait.h>
#include <unistd.h>

namespace spricka::program {

namespace {

/// The end of what a process says that is kept [bytes].
constexpr std::size_t most_said = 8192;
/// What a process is given to remove its files, before it is ended by force [s].
constexpr double patience = 10.0;

std::vector<std::string> words_of(const ChildRun& run) {
  if (!run.other.empty()) {
    return run.other;
  }
  std::vector<std::string> words{
      "spricka",        "run",       run.deck.string(),          "--quiet", "--out",
      run.out.string(), "--threads", std::to_string(run.threads)};
  if (!run.engine.empty()) {
    words.insert(words.end(), {"--engine", run.engine});
  }
  for (const auto& [name, value] : run.defines) {
    words.insert(words.end(), {"-D", fmt::format("{}={}", name, value)});
  }
  return words;
}

/// Starts it with nothing to read and nobody to hear its stdout; 0 or the error's number.
int spawn_run(const std::string& program, std::vector<std::string> words, int said, pid_t& pid) {
  posix_spawn_file_actions_t actions{};
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, said, STDERR_FILENO);
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  const int trouble =
      posix_spawn(&pid, program.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return trouble;
}

double seconds_of(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

/// What stands in the pipe, to the end of what was said before; false: nobody can write any more.
bool take_said(int words, std::string& said) {
  std::array<char, 4096> some{};
  const ssize_t got = read(words, some.data(), some.size());
  if (got < 0) {
    return errno == EINTR || errno == EAGAIN;
  }
  said.append(some.data(), static_cast<std::size_t>(got));
  if (said.size() > 2 * most_said) {
    said.erase(0, said.size() - most_said);
  }
  return got > 0;
}

double cpu_of(pid_t pid) {
  clockid_t clock{};
  timespec now{};
  if (clock_getcpuclockid(pid, &clock) != 0 || clock_gettime(clock, &now) != 0) {
    return 0.0;
  }
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Listens to a process while it runs.
struct Listener {
  pid_t pid;
  int words; ///< what it says, the end of a pipe
  std::string said = {};
  std::size_t peak = 0;

  /// Until it has ended, or is to be ended (true).
  bool wait(double seconds, double cpu_seconds) {
    constexpr int look_again = 20; // [ms]
    const base::Stopwatch watch;
    for (;;) {
      if ((seconds > 0.0 && watch.wall_time() >= seconds) ||
          (cpu_seconds > 0.0 && cpu_of(pid) >= cpu_seconds)) {
        return true;
      }
      pollfd end{words, POLLIN, 0};
      if (poll(&end, 1, look_again) > 0 && !take_said(words, said)) {
        return false;
      }
      peak = std::max(peak, base::peak_memory_of_process(std::to_string(pid)).value_or(0));
    }
  }
};

// The kernel's name of the processor, where it has one.
std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) {
      return line.substr(colon + 2);
    }
  }
  utsname names{};
  return uname(&names) == 0 ? std::string(names.machine) : "unknown processor";
}

} // namespace

std::filesystem::path running_program_file() {
  return std::filesystem::read_symlink("/proc/self/exe");
}

ChildRunner::ChildRunner(std::filesystem::path program) : program_(std::move(program)) {}

bool ChildRunner::start(const ChildRun& run, pid_t& pid, int& words) {
  std::array<int, 2> pipe_ends{};
  if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0) {
    throw std::system_error(errno, std::generic_category(), "pipe");
  }
  const std::string program = run.other.empty() ? program_.string() : run.other.front();
  int trouble = 0;
  bool begun = false;
  {
    const std::scoped_lock lock(guard_);
    if (!stopped_) {
      trouble = spawn_run(program, words_of(run), pipe_ends[1], pid);
      begun = trouble == 0;
    }
    if (begun) {
      running_.insert(pid);
    }
  }
  close(pipe_ends[1]); // the process has one of its own
  words = pipe_ends[0];
  if (!begun) {
    close(words);
  }
  if (trouble != 0) {
    throw std::system_error(trouble, std::generic_category(), program);
  }
  return begun;
}

ChildProcessResult ChildRunner::reap(pid_t pid, std::size_t seen, std::size_t inherited) {
  // Its number is not given to another process before it is reaped: until then it may be killed.
  siginfo_t info{};
  while (waitid(P_PID, static_cast<id_t>(pid), &info, WEXITED | WNOWAIT) != 0 && errno == EINTR) {
  }
  const std::scoped_lock lock(guard_);
  int status = 0;
  rusage usage{};
  wait4(pid, &status, 0, &usage);
  running_.erase(pid);
  gone_.notify_all();
  ChildProcessResult end;
  end.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  end.exit_code = end.signal != 0 ? 128 + end.signal : WEXITSTATUS(status);
  end.cpu = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
  const auto counted = static_cast<std::size_t>(usage.ru_maxrss) * 1024; // Linux counts KiB
  end.peak_memory = counted > inherited || seen == 0 ? counted : seen;
  return end;
}

void ChildRunner::run_all_children(
    std::span<const ChildRun> runs, int at_once,
    const std::function<void(std::size_t, const ChildProcessResult&)>& ended) {
  base::parallel_for(runs.size(), at_once, [&](std::size_t i) {
    pid_t pid = -1;
    int words = -1;
    const base::Stopwatch watch;
    if (!start(runs[i], pid, words)) {
      return;
    }
    Listener listener{.pid = pid, .words = words};
    const bool late = listener.wait(runs[i].seconds, runs[i].cpu_seconds);
    if (late) {
      kill(pid, SIGTERM); // it is not reaped yet
      if (listener.wait(patience, 0.0)) {
        kill(pid, SIGKILL);
      }
    }
    close(words);
    // A process begins with the peak of the one that started it.
    ChildProcessResult end = reap(pid, listener.peak, base::peak_memory());
    end.late = late;
    end.wall = watch.wall_time();
    const std::string& said = listener.said;
    end.messages = said.size() > most_said ? said.substr(said.size() - most_said) : said;
    const std::scoped_lock lock(telling_);
    if (!stopped()) {
      ended(i, end);
    }
  });
}

void ChildRunner::stop() {
  std::unique_lock lock(guard_);
  stopped_ = true;
  const auto none = [this] { return running_.empty(); };
  for (const int signal : {SIGTERM, SIGKILL}) {
    for (const pid_t pid : running_) {
      kill(pid, signal);
    }
    if (gone_.wait_for(lock, std::chrono::duration<double>(patience), none)) {
      return;
    }
  }
}

bool ChildRunner::stopped() const {
  const std::scoped_lock lock(guard_);
  return stopped_;
}

int core_count() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  const int own =
      sched_getaffinity(0, sizeof cores, &cores) == 0 ? std::max(1, CPU_COUNT(&cores)) : 1;
  return std::min(own, scheduler_cpu_count().value_or(own));
}

std::string machine_description() {
  return fmt::format("{}, {} cores, {:.0f} GB", processor_name(), core_count(),
                     1e-9 * static_cast<double>(base::process_memory_limit()));
}

std::string program_version_and_build() {
  // Piece by piece: what this process once had counts as memory of all that it starts.
  std::ifstream file(running_program_file(), std::ios::binary);
  std::string piece(base::mebibyte, '\0');
  std::string hashes;
  while (file.read(piece.data(), static_cast<std::streamsize>(piece.size())) || file.gcount() > 0) {
    hashes += archive::hash_bytes({piece.data(), static_cast<std::size_t>(file.gcount())});
  }
  const std::string hash = archive::hash_bytes(hashes);
  return fmt::format("spricka {} ({})", SPRICKA_VERSION, hash.substr(0, 8));
}

} // namespace spricka::program
