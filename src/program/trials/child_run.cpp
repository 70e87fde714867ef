// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/trials/child_run.hpp"

#include "base/clock.hpp"
#include "base/parallel.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace spricka::program {

namespace {

/// The end of what a process says that is kept [bytes].
constexpr std::size_t most_said = 8192;
/// What a process is given to remove its files, before it is ended by force [s].
constexpr double patience = 10.0;

std::vector<std::string> words_of(const ChildRun& run) {
  std::vector<std::string> words{
      "spricka",        "run",       run.deck.string(),          "--quiet", "--out",
      run.out.string(), "--threads", std::to_string(run.threads)};
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

/// High water mark of the resident set of a process that runs [bytes]; 0: not told.
std::size_t high_water(pid_t pid) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  for (std::string word; status >> word;) {
    if (word == "VmHWM:") {
      std::size_t kibibytes = 0;
      status >> kibibytes;
      return 1024 * kibibytes;
    }
  }
  return 0;
}

/// Listens until the process has ended, or is to be ended (true), and watches its memory.
bool listen(int words, double seconds, std::string& said, pid_t pid, std::size_t& peak) {
  constexpr int pace = 20; // [ms]
  const base::Stopwatch watch;
  for (;;) {
    peak = std::max(peak, high_water(pid));
    const double left = seconds > 0.0 ? seconds - watch.wall() : 0.0;
    if (seconds > 0.0 && left <= 0.0) {
      return true;
    }
    pollfd end{words, POLLIN, 0};
    const int wait = seconds > 0.0
                         ? std::min(pace, static_cast<int>(std::ceil(1e3 * std::min(left, 1e6))))
                         : pace;
    if (poll(&end, 1, wait) > 0 && !take_said(words, said)) {
      return false;
    }
  }
}

} // namespace

std::filesystem::path own_program() {
  return std::filesystem::read_symlink("/proc/self/exe");
}

ChildRuns::ChildRuns(std::filesystem::path program) : program_(std::move(program)) {}

bool ChildRuns::start(const ChildRun& run, pid_t& pid, int& words) {
  std::array<int, 2> pipe_ends{};
  if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0) {
    throw std::system_error(errno, std::generic_category(), "pipe");
  }
  int trouble = 0;
  bool begun = false;
  {
    const std::scoped_lock lock(guard_);
    if (!stopped_) {
      trouble = spawn_run(program_.string(), words_of(run), pipe_ends[1], pid);
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
    throw std::system_error(trouble, std::generic_category(), program_.string());
  }
  return begun;
}

ChildEnd ChildRuns::reap(pid_t pid) {
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
  ChildEnd end;
  end.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  end.exit_code = end.signal != 0 ? 128 + end.signal : WEXITSTATUS(status);
  end.cpu = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
  end.peak_memory = static_cast<std::size_t>(usage.ru_maxrss) * 1024; // Linux counts KiB
  return end;
}

void ChildRuns::run(std::span<const ChildRun> runs, int at_once,
                    const std::function<void(std::size_t, const ChildEnd&)>& ended) {
  base::parallel_for(runs.size(), at_once, [&](std::size_t i) {
    pid_t pid = -1;
    int words = -1;
    const base::Stopwatch watch;
    if (!start(runs[i], pid, words)) {
      return;
    }
    std::string said;
    std::size_t peak = 0;
    const bool late = listen(words, runs[i].seconds, said, pid, peak);
    if (late) {
      kill(pid, SIGTERM); // it is not reaped yet
      if (listen(words, patience, said, pid, peak)) {
        kill(pid, SIGKILL);
      }
    }
    close(words);
    ChildEnd end = reap(pid);
    // What the system says counts the memory of this process at the moment of the start as well.
    if (end.peak_memory <= base::peak_memory() && peak > 0) {
      end.peak_memory = peak;
    }
    end.late = late;
    end.wall = watch.wall();
    end.messages = said.size() > most_said ? said.substr(said.size() - most_said) : said;
    const std::scoped_lock lock(telling_);
    if (!stopped()) {
      ended(i, end);
    }
  });
}

void ChildRuns::stop() {
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

bool ChildRuns::stopped() const {
  const std::scoped_lock lock(guard_);
  return stopped_;
}

} // namespace spricka::program
