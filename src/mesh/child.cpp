// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/child.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <string_view>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace spricka::mesh {
namespace {

/// Bytes of address space the process holds, from /proc; 0 where that cannot be read.
std::size_t held() {
  std::size_t pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%zu", &pages) != 1) {
      pages = 0;
    }
    std::fclose(file);
  }
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

void be_silent() {
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) {
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
  }
}

void limit(int resource, std::size_t most) {
  const rlimit both{most, most};
  setrlimit(static_cast<__rlimit_resource>(resource), &both);
}

bool write_all(int to, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(to, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) {
      return false;
    }
    bytes.remove_prefix(static_cast<std::size_t>(written < 0 ? 0 : written));
  }
  return true;
}

std::string read_all(int from) {
  static constexpr std::size_t chunk = std::size_t{1} << 16U;
  std::string bytes;
  for (ssize_t got = 1; got != 0;) {
    const std::size_t filled = bytes.size();
    bytes.resize(filled + chunk);
    got = read(from, bytes.data() + filled, chunk);
    bytes.resize(filled + static_cast<std::size_t>(got > 0 ? got : 0));
    if (got < 0 && errno != EINTR) {
      break;
    }
  }
  return bytes;
}

} // namespace

std::optional<std::string> in_child(const std::function<std::string()>& work, std::size_t memory) {
  std::array<int, 2> ends{};
  std::fflush(nullptr);
  const std::size_t before = held();
  if (pipe(ends.data()) != 0) {
    return work();
  }
  const pid_t child = fork();
  if (child < 0) {
    close(ends[0]);
    close(ends[1]);
    return work();
  }
  if (child == 0) {
    close(ends[0]);
    be_silent();
    limit(RLIMIT_CORE, 0);
    if (before > 0) {
      limit(RLIMIT_AS, before + memory);
    }
    bool done = false;
    try {
      done = write_all(ends[1], work());
    } catch (...) { // too little memory
    }
    _exit(done ? 0 : 1);
  }
  close(ends[1]);
  std::string bytes = read_all(ends[0]);
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) {
      return std::nullopt;
    }
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? std::optional(std::move(bytes))
                                                       : std::nullopt;
}

} // namespace spricka::mesh
